#!/usr/bin/env bash
# sources_test.sh SOURCE-FOLDER [core-only]
# The arrows app -> ui -> core as the includes draw them:
#   core and the command line include no Qt, and nothing from the layers above them;
#   ui includes nothing from app;
#   a scene includes no other scene but workshop those that it joins, in core, in ui and in the
#   tests of both; core's ground (case files, numerics, drawing, bibliography, shop) includes
#   nothing that stands on it, nor does a scene include the methods or the registry;
#   folders form no circles.
# That a model includes no widget, the compiler sees: their library has no QtWidgets to include.
set -euo pipefail
cd "$1"
shift
faults=0
fault() {
    printf 'FAULT: %s\n' "$*"
    faults=$((faults + 1))
}

sources() { find "$@" -type f \( -name '*.cpp' -o -name '*.h' \) | sort; }

# Every include of the project, read once: quoted["FILE"] and angled["FILE"] hold names and spaces.
declare -A quoted=() angled=()
while IFS=$'\t' read -r file kind name; do
    if [ "$kind" = '"' ]; then
        quoted[$file]+="$name "
    else
        angled[$file]+="$name "
    fi
done < <(find core app ui tests -type f \( -name '*.cpp' -o -name '*.h' \) -exec sed -n -E \
    '/^[[:space:]]*#[[:space:]]*include/ { F; s/^[[:space:]]*#[[:space:]]*include[[:space:]]*(["<])([^">]*)[">].*/\t\1\t\2/p }' \
    {} + | paste -d '' - -)

# resolve FILE INCLUDE ROOT...: sets `found` to where a quoted include lies, beside the file or
# under a root.
resolve() {
    local file=$1 include=$2 base
    shift 2
    found=""
    for base in "${file%/*}" "$@"; do
        if [ -f "$base/$include" ]; then
            found=$base/$include
            return 0
        fi
    done
    return 1
}

# check_layer LAYER ROOT...: every quoted include of LAYER lies under one of the ROOTs.
check_layer() {
    local layer=$1 file include
    shift
    for file in $(sources "$layer"); do
        for include in ${quoted[$file]:-}; do
            case $include in *.moc | moc_*.cpp | ui_*.h) continue ;; esac
            if ! resolve "$file" "$include" "$@"; then
                fault "$file includes \"$include\", which is not under: $*"
            elif [[ $found == */../* ]]; then
                fault "$file includes \"$include\" through ..; include from the layer's root"
            fi
        done
    done
}

check_no_qt() {
    local file include
    for file in $(sources "$@"); do
        for include in ${angled[$file]:-} ${quoted[$file]:-}; do
            case $include in
                Q[A-Z]* | Qt*/* | q[a-z]*.h) fault "$file includes $include: no Qt in this layer" ;;
            esac
        done
    done
}

# A layer with no files would pass every check.
[ ${#quoted[@]} -gt 10 ] || fault "the includes could not be read: nothing was checked"

check_layer core core
check_layer app/cli core
check_no_qt core app/cli

# check_folders_apart FILES-UNDER FOLDER...: no file there includes from one of the folders.
check_folders_apart() {
    local under=$1 file include folder
    shift
    [ -d "$under" ] || fault "$under is not there: nothing was checked"
    for file in $(sources "$under"); do
        for include in ${quoted[$file]:-}; do
            for folder in "$@"; do
                case $include in
                    "${folder:-none}"/*) fault "$file includes \"$include\": ${under#*/} must not know $folder" ;;
                esac
            done
        done
    done
}
# A folder of core with a solver.cpp is a scene.
scenes=()
for file in core/*/solver.cpp; do
    file=${file%/solver.cpp}
    scenes+=("${file#core/}")
done
[ ${#scenes[@]} -eq 6 ] || fault "the scenes could not be found: ${scenes[*]}"
for ground in case-file numerics drawing bibliography shop; do
    check_folders_apart "core/$ground" "${scenes[@]}" methods scenes
done
check_folders_apart core/numerics case-file drawing bibliography
# What a shop has besides its job: journal, card, scale.
check_folders_apart ui/shop "${scenes[@]}" methods
for scene in "${scenes[@]}"; do
    others=()
    for other in "${scenes[@]}"; do
        # A job of the workshop is solved by the scenes of its parts.
        case "$scene $other" in
            "$other $other" | "workshop v8-plugs" | "workshop bob-weights") ;;
            *) others+=("$other") ;;
        esac
    done
    check_folders_apart "core/$scene" "${others[@]}" methods scenes
    check_folders_apart "tests/core/$scene" "${others[@]}" methods
    # These are parts of a job: the window shows them on the page of the workshop.
    case $scene in v8-plugs | bob-weights) continue ;; esac
    check_folders_apart "ui/$scene" "${others[@]}" methods
    check_folders_apart "tests/ui/$scene" "${others[@]}" methods
done

# check_no_circles LAYER: what its folders include from one another leads nowhere back.
check_no_circles() {
    local layer=$1 file include from to pairs="" circles
    for file in $(sources "$layer"); do
        from=${file#*/}
        from=${from%/*}
        for include in ${quoted[$file]:-}; do
            to=${include%/*}
            [ "$to" = "$from" ] || [ ! -f "$layer/$include" ] || pairs+="$from $to"$'\n'
        done
    done
    [ -n "$pairs" ] || fault "no folder of $layer includes from another: nothing was checked"
    if ! circles=$(tsort <<<"$pairs" 2>&1 >/dev/null); then
        fault "folders of $layer form circles: $(sed 's/^tsort: //; s/^-: .*/;/' <<<"$circles" | paste -sd ' ')"
    fi
}
check_no_circles core
[ "${1:-}" = core-only ] || check_no_circles ui

if grep -nE 'Qt[0-9]*(::|[[:space:]]+REQUIRED|[[:space:]]+COMPONENTS)' core/CMakeLists.txt; then
    fault "core/CMakeLists.txt asks for Qt"
fi

# clang-tidy reads the sources as they are, before anything is built.
for file in $(sources ui app); do
    case " ${quoted[$file]:-}" in
        *.moc\ *) fault "$file includes what moc makes of it: a class with Q_OBJECT stands in a header" ;;
    esac
done

if [ "${1:-}" != core-only ]; then
    check_layer ui ui core
    check_layer app/desktop app/desktop ui core
fi

if [ $faults -ne 0 ]; then
    printf '%d faults\n' "$faults"
    exit 1
fi
