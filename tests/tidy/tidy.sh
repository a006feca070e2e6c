#!/bin/sh
# tidy.sh CLANG-TIDY BUILD-FOLDER SOURCE STAMP: checks one file and touches STAMP if it passed.
# clang-tidy counts the warnings it suppressed on standard error; that is shown only on a failure.
# RAVNOVES_TIDY_CHECKS is added to the checks of .clang-tidy, for example to leave the analyser out.
if "$1" -p "$2" --quiet ${RAVNOVES_TIDY_CHECKS:+--checks="$RAVNOVES_TIDY_CHECKS"} "$3" 2>"$4.log"; then
    rm -f "$4.log"
    touch "$4"
else
    cat "$4.log" >&2
    exit 1
fi
