#compdef ravnoves-cli

local -a commands help
commands=(
    'solve:solve a case file'
    'study:vary the inputs of a case as its study says'
    'methods:measure time, error and limits of each numerical method'
    'validate:compute every number printed in the four papers and compare'
)
help=('(- *)'{-h,--help}'[show the options and exit]')
if ((CURRENT == 2)); then
    _arguments $help '(- *)--version[show the version and exit]' '1:command:{_describe command commands}'
    return
fi
local command=$words[2]
shift words
((CURRENT--))
case $command in
    solve)
        _arguments $help '(-o --output --batch)'{-o,--output}'[write the result to this file]:file:_files' \
            '(-o --output *)--batch[read one case per line from standard input]' \
            '*--only[print only these values of the result]:JSON pointers' \
            '--allow-files[let the cases of --batch read files elsewhere]' \
            '1:case file:_files -g "*.json"'
        ;;
    study)
        _arguments $help '(-o --output)'{-o,--output}'[write to this file]:file:_files' \
            '(--merge)--shard[compute the K-th of N parts]:K/N' \
            '(--shard 1)--merge[merge parts]:*:part:_files' \
            '--threads[number of threads]:count' \
            '1:case file:_files -g "*.json"'
        ;;
    methods)
        _arguments $help '--csv[write the tables to this file too]:file:_files' \
            '(--kernel --csv)--case[what contributes to the results of this case]:case file:_files -g "*.json"' \
            '--kernel[one kernel instead of all]:kernel:(slider-crank cycle-mean moment-range best-angle best-position guide inertia-orders hinge-motion scatter)'
        ;;
    validate)
        _arguments $help '--csv[write the table to this file too]:file:_files'
        ;;
esac
