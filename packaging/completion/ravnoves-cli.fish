# fish completion for ravnoves-cli

complete -c ravnoves-cli -f
complete -c ravnoves-cli -s h -l help -d 'Show the options and exit'
complete -c ravnoves-cli -n __fish_use_subcommand -l version -d 'Show the version and exit'
complete -c ravnoves-cli -n __fish_use_subcommand -a solve -d 'Solve a case file'
complete -c ravnoves-cli -n __fish_use_subcommand -a study -d 'Vary the inputs of a case'
complete -c ravnoves-cli -n __fish_use_subcommand -a methods -d 'Measure the numerical methods'
complete -c ravnoves-cli -n __fish_use_subcommand -a validate -d 'Compute every number of the papers and compare'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve study' -a '(__fish_complete_suffix .json)'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve study' -s o -l output -r -F -d 'Write the result to this file'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -l batch -d 'Read one case per line from standard input'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -l only -x -d 'Print only these values of the result'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from solve' -l allow-files -d 'Let the cases of --batch read files elsewhere'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from study' -l shard -x -d 'Take the K-th of N parts: K/N'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from study' -l merge -r -F -d 'Put parts together'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from study' -l threads -x -d 'Work with so many threads'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from methods' -l kernel -x -a 'slider-crank cycle-mean moment-range best-angle best-position guide inertia-orders hinge-motion scatter' -d 'One kernel instead of all'
complete -c ravnoves-cli -n '__fish_seen_subcommand_from methods validate' -l csv -r -F -d 'Write the table to this file too'
