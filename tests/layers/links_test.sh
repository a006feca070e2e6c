#!/usr/bin/env bash
# links_test.sh PROGRAM PATTERN: neither the program nor a library that it loads needs what matches.
set -euo pipefail
program=$1
needed=$(readelf -d "$program" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
loaded=$(ldd "$program")
printf 'needs:\n%s\nloads:\n%s\n' "$needed" "$loaded"
# A program that holds all it runs loads nothing; Qt comes as shared libraries only.
if [ -z "$needed" ] && grep -q 'statically linked' <<<"$loaded"; then
    exit 0
fi
grep -q '^libc\.so' <<<"$needed" || {
    echo "the list of needed libraries could not be read"
    exit 1
}
if grep -E 'not found' <<<"$loaded"; then
    exit 1
fi
if grep -iE "$2" <<<"$needed $loaded"; then
    echo "$(basename "$program") must run without these"
    exit 1
fi
