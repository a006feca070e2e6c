# fish completion for ravnoves-cli

complete -c ravnoves-cli -f
complete -c ravnoves-cli -s h -l help -d 'Show the options and exit'
complete -c ravnoves-cli -n __fish_use_subcommand -l version -d 'Show the version and exit'
complete -c ravnoves-cli -n __fish_use_subcommand -a solve -d 'Solve a case file'
complete -c ravnoves-cli -n __fish_use_subcommand -a methods -d 'Measure the numerical methods'
complete -c ravnoves-cli -n __fish_use_subcommand -a validate -d 'Compute every number of the papers and compare'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -a '(__fish_complete_suffix .json)'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -s o -l output -r -F -d 'Write the result to this file'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -l batch -d 'Read one case per line from standard input'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -l only -x -d 'Print only these values of the result'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -l allow-files -d 'Let the cases of --batch read files elsewhere'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from methods' -l kernel -x -a 'slider-crank cycle-mean moment-range best-angle best-position guide inertia-orders hinge-motion' -d 'One kernel instead of all'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from methods validate' -l csv -r -F -d 'Write the table to this file too'
