#!/usr/bin/env bash
# options_test.sh FOLDER RAVNOVES-CLI [RAVNOVES]: the manual and completions as they are installed
# Manual pages and completions know every option and every word that the programs take.
set -euo pipefail
packaging=$1 cli=$2 desktop=${3:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 700 "$folder"
export XDG_RUNTIME_DIR=$folder XDG_CONFIG_HOME=$folder/config LC_ALL=C.UTF-8
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM

words=0 faults=0
fault() {
    printf 'FAULT: %s\n' "$*"
    faults=$((faults + 1))
}
# known PROGRAM WORD…: each stands in the manual page and in the three completions of the program.
# fish takes the dashes off an option.
known() {
    local program=$1 word
    shift
    for word in "$@"; do
        words=$((words + 1))
        sed 's/\\-/-/g; s/\\[fF][BIPR]//g' "$packaging/$program.1" |
            grep -E -- "(^|[^-a-z])$word([^-a-z]|\$)" >/dev/null ||
            fault "$program.1 does not name $word"
        local shell
        for shell in bash zsh; do
            grep -E -- "(^|[^-a-z])$word([^-a-z]|\$)" "$packaging/$program.$shell" >/dev/null ||
                fault "$program.$shell does not name $word"
        done
        local fish=$word
        case $word in
            --*) fish="-l ${word#--}" ;;
            -?) fish="-s ${word#-}" ;;
        esac
        grep -E -- "[ ']$fish( |'|\$)" "$packaging/$program.fish" >/dev/null ||
            fault "$program.fish does not name $word"
    done
}
# known_of COMMAND OPTION…: each stands in the command's own part of the four files.
known_of() {
    local command=$1 part word
    shift
    declare -A parts=(
        [1]=$(sed -n "/^\.SS $command\$/,/^\.S/p" "$packaging/ravnoves-cli.1" |
            sed 's/\\-/-/g; s/\\f[BIPR]//g')
        [bash]=$(grep -E "^ +$command\) words" "$packaging/ravnoves-cli.bash")
        [zsh]=$(sed -n "/^    $command)\$/,/;;/p" "$packaging/ravnoves-cli.zsh")
        # With its dashes again.
        [fish]=$(grep -E "_from [^']*\b$command\b" "$packaging/ravnoves-cli.fish" |
            sed 's/ -s / -/; s/ -l / --/')
    )
    for word in "$@"; do
        words=$((words + 1))
        for part in "${!parts[@]}"; do
            grep -E -- "(^|[^-a-z])$word([^-a-z]|\$)" <<<"${parts[$part]}" >/dev/null ||
                fault "ravnoves-cli.$part does not name $word of $command"
        done
    done
}
# The options that a --help lists, at the start of its lines.
options() { sed -nE 's/^ +(-[^ ].*)$/\1/p' | sed -E 's/  .*//' | grep -oE '(^|[ ,])--?[a-z][a-z-]*' | tr -d ' ,'; }

"$cli" --help >"$folder/help"
mapfile -t listed < <(options <"$folder/help")
known ravnoves-cli "${listed[@]}"
mapfile -t commands < <(sed -n '/^Subcommands:/,$s/^  \([a-z][a-z-]*\) .*/\1/p' "$folder/help")
[ ${#commands[@]} -ge 3 ] || fault "--help lists ${#commands[@]} commands"
known ravnoves-cli "${commands[@]}"
for command in "${commands[@]}"; do
    "$cli" "$command" --help >"$folder/help"
    mapfile -t listed < <(options <"$folder/help" | grep -vxE -e '-h|--help')
    known_of "$command" "${listed[@]}"
    kernels=$(sed -n 's/^Kernels: \(.*\)\.$/\1/p' "$folder/help")
    # shellcheck disable=SC2086 # words
    known ravnoves-cli ${kernels//,/}
done

if [ -n "$desktop" ]; then
    mapfile -t listed < <("$desktop" --help | options)
    known ravnoves "${listed[@]}"
    scenes=$("$desktop" --screenshot "$folder/none.png" --scene none 2>&1 |
        sed -n 's/^--scene: must be one of \(.*\), got none$/\1/p' || true)
    [ -n "$scenes" ] || fault "the scenes are not found out"
    # shellcheck disable=SC2086 # words
    known ravnoves ${scenes//,/}
fi

# The manual pages are what man and whatis expect.
for page in "$packaging"/*.1; do
    if command -v man >/dev/null; then
        said=$(MANWIDTH=80 man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null) || fault "man $page fails"
        [ -z "$said" ] || fault "man -l $page: $said"
    fi
    if command -v lexgrog >/dev/null; then
        lexgrog "$page" >/dev/null || fault "$page has no NAME that whatis reads"
    fi
    for section in NAME SYNOPSIS DESCRIPTION OPTIONS '"\?EXIT STATUS' 'SEE ALSO'; do
        grep "^\.SH $section" "$page" >/dev/null || fault "$page has no section $section"
    done
done
for script in "$packaging"/*.bash; do
    bash -n "$script" || fault "$script does not parse"
done

# What bash is offered, word by word.
# offered PROGRAM WORD…: for the last word, in order, on one line.
offered() {
    bash -c '
        compopt() { :; }
        cd "$1"; shift
        . "$1"; shift
        COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
        "_${1//-/_}"
        printf "%s\n" "${COMPREPLY[@]}" | sort | paste -sd " "' \
        bash "$folder" "$packaging/$1.bash" "$@"
}
touch "$folder/a.case.json" "$folder/a.txt"
# check EXPECTED PROGRAM WORD…
check() {
    local expected=$1 got
    shift
    got=$(offered "$@")
    [ "$got" = "$expected" ] || fault "after '$*' bash offers '$got', not '$expected'"
}
if [ -n "$desktop" ]; then
    check "balance-shaft" ravnoves --scene ba
    check "--scale --scene --screenshot --set --size" ravnoves --s
    check "a.case.json" ravnoves a
    check "dark" ravnoves --theme d
fi
check "methods" ravnoves-cli m
check "a.case.json" ravnoves-cli solve a
check "--batch" ravnoves-cli solve --b
check "guide" ravnoves-cli methods --kernel g
check "--csv" ravnoves-cli validate --c

[ $words -ge 20 ] || fault "only $words words were looked for"
[ $faults -eq 0 ] || exit 1
