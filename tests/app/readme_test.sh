#!/usr/bin/env bash
# readme_test.sh SOURCE-FOLDER RAVNOVES-CLI
# Runs the marked examples of README.md and compares what they print: a line "…" stands for any
# number of lines, every other line must be there as printed, in its place.
set -euo pipefail
source_folder=$1
bin=$(dirname "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
ln -s "$source_folder/resources" "$folder/resources"

examples=0
faults=0
command="" expected=()

check() {
    [ -n "$command" ] || return 0
    local -a printed=()
    mapfile -t printed < <(cd "$folder" && PATH=$bin:$PATH bash -c "$command" 2>&1)
    local at=0 gap=no line trimmed
    for line in "${expected[@]}"; do
        trimmed=${line#"${line%%[! ]*}"}
        if [ "$trimmed" = … ]; then
            gap=yes
            continue
        fi
        while [ $gap = yes ] && [ $at -lt ${#printed[@]} ] && [ "${printed[$at]}" != "$line" ]; do
            at=$((at + 1))
        done
        gap=no
        if [ "${printed[$at]-<end of output>}" != "$line" ]; then
            printf 'FAULT: %s\n  README: %s\n  prints: %s\n' \
                "$command" "$line" "${printed[$at]-<end of output>}"
            faults=$((faults + 1))
            return 0
        fi
        at=$((at + 1))
    done
    if [ $gap = no ] && [ $at -ne ${#printed[@]} ]; then
        printf 'FAULT: %s\n  prints more than the README says: %s\n' "$command" "${printed[$at]}"
        faults=$((faults + 1))
    fi
    examples=$((examples + 1))
}

state=text
while IFS= read -r line; do
    case $state in
        text) if [[ $line == '<!-- example:'* ]]; then state=marked; fi ;;
        marked) if [[ $line == '```'* ]]; then state=example; fi ;;
        example)
            if [[ $line == '```' || $line == '$ '* ]]; then
                check
                command=${line#'$ '} expected=()
                if [[ $line == '```' ]]; then
                    command="" state=text
                fi
            else
                expected+=("$line")
            fi
            ;;
    esac
done <"$source_folder/README.md"

printf '%d examples\n' "$examples"
[ $examples -ge 3 ] || faults=$((faults + 1))
[ $faults -eq 0 ]
