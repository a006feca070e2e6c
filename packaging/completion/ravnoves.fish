# fish completion for ravnoves

complete -c ravnoves -f -a '(__fish_complete_suffix .json)'
complete -c ravnoves -l scene -x -a 'balance-shaft elastic-hinge v8-plugs inertia-moments methods' -d 'Start with this scene'
complete -c ravnoves -l case -r -d 'Open this case file'
complete -c ravnoves -l set -x -d 'Set a value of the case or of the page'
complete -c ravnoves -l screenshot -r -d 'Write the window as a PNG picture and exit'
complete -c ravnoves -l size -x -d 'Size of the window, for example 1280x800'
complete -c ravnoves -l theme -x -a 'light dark system' -d 'Colours'
complete -c ravnoves -l language -x -a 'en ru' -d 'Language of the program'
complete -c ravnoves -l text -x -a '85 100 125 150 200' -d 'Size of the text in percent'
complete -c ravnoves -s h -l help -d 'Show the options and exit'
complete -c ravnoves -l help-all -d 'The same with the options of Qt'
complete -c ravnoves -s v -l version -d 'Show the version and exit'
