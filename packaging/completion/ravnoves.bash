# bash completion for ravnoves

_ravnoves() {
    local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]}
    COMPREPLY=()
    case $option in
        --scene)
            mapfile -t COMPREPLY < <(compgen -W \
                "start @pages@" -- "$word")
            return
            ;;
        --theme)
            mapfile -t COMPREPLY < <(compgen -W "light dark system" -- "$word")
            return
            ;;
        --language)
            mapfile -t COMPREPLY < <(compgen -W "en ru" -- "$word")
            return
            ;;
        --text)
            mapfile -t COMPREPLY < <(compgen -W "85 100 125 150 200" -- "$word")
            return
            ;;
        --scale)
            mapfile -t COMPREPLY < <(compgen -W "1 2" -- "$word")
            return
            ;;
        --size | --set) return ;;
    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "--scene --case --set --screenshot --report --size --theme
            --language --text --scale -h --help --help-all -v --version" -- "$word")
        return
    fi
    compopt -o filenames
    local suffix=json
    [ "$option" != --screenshot ] || suffix=png
    [ "$option" != --report ] || suffix=pdf
    mapfile -t COMPREPLY < <(compgen -f -X "!*.$suffix" -- "$word"; compgen -d -- "$word")
}
complete -F _ravnoves ravnoves
