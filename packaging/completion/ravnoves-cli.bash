# bash completion for ravnoves-cli

_ravnoves_cli() {
    local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]}
    local command=${COMP_WORDS[1]} words="-h --help"
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W "solve study methods validate -h --help --version" -- "$word")
        return
    fi
    case $option in
        --kernel)
            mapfile -t COMPREPLY < <(compgen -W "slider-crank cycle-mean moment-range best-angle
                best-position guide inertia-orders hinge-motion scatter" -- "$word")
            return
            ;;
        -o | --output | --csv | --case | --merge)
            compopt -o filenames
            mapfile -t COMPREPLY < <(compgen -f -- "$word")
            return
            ;;
    esac
    case $command in
        solve) words+=" -o --output --batch --only --allow-files" ;;
        study) words+=" -o --output --shard --merge --threads" ;;
        methods) words+=" --kernel --csv --case" ;;
        validate) words+=" --csv" ;;
        *) return ;;
    esac
    if [[ $word == -* || ($command != solve && $command != study) ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
        return
    fi
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -X '!*.json' -- "$word"; compgen -d -- "$word")
}
complete -F _ravnoves_cli ravnoves-cli
