#!/bin/sh
# tidy.sh CLANG-TIDY BUILD-FOLDER SOURCE STAMP [CHECKS]: checks one file; if it passed, touches STAMP
# and writes what it includes into STAMP.d, so that it is checked again when one of those changes.
# CHECKS come on top of those of .clang-tidy.
# clang-tidy counts the warnings it suppressed on standard error; that is shown only on a failure.
if ! "$1" -p "$2" --quiet ${5:+--checks="$5"} "$3" 2>"$4.log"; then
    cat "$4.log" >&2
    exit 1
fi
rm -f "$4.log"
"$(dirname "$0")/includes.py" "$2/compile_commands.json" "$3" "$4" >"$4.d" || exit 1
touch "$4"
