#!/bin/sh
# tidy.sh CLANG-TIDY BUILD-FOLDER SOURCE STAMP [CHECKS]: checks one file, touches STAMP if it passed.
# CHECKS come on top of those of .clang-tidy.
# clang-tidy counts the warnings it suppressed on standard error; that is shown only on a failure.
if "$1" -p "$2" --quiet ${5:+--checks="$5"} "$3" 2>"$4.log"; then
    rm -f "$4.log"
    touch "$4"
else
    cat "$4.log" >&2
    exit 1
fi
