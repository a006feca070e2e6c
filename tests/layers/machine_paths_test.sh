#!/usr/bin/env bash
# machine_paths_test.sh SOURCE-FOLDER: no text of the project names a folder of someone's machine.
set -euo pipefail
cd "$1"
list_files() {
    if git rev-parse --is-inside-work-tree >/dev/null 2>&1 &&
        [ "$(git rev-parse --show-toplevel)" = "$PWD" ]; then
        git ls-files -z --cached --others --exclude-standard
    else
        find . \( -name build -o -name 'build-*' -o -name .git -o -name .cache \) -prune -o -type f -print0
    fi
}
files=$(list_files | tr '\0' '\n' | wc -l)
[ "$files" -gt 20 ] || {
    echo "only $files files were found: nothing was checked"
    exit 1
}
# A path of a home or work folder, at the start of a word; then the checkout's own place.
homes='(^|[^A-Za-z0-9_.}/-])/(home|Users|root|work|workspace|mnt|media)/[A-Za-z0-9_.]'
status=0
if list_files | xargs -0 grep -nIE -- "$homes"; then
    status=1
fi
if list_files | xargs -0 grep -nIF -- "$PWD/"; then
    status=1
fi
[ $status = 0 ] || echo "text in the tree names a machine's path"
exit $status
