#compdef ravnoves

_arguments \
    '--scene[open this module]:scene:(start @pages@)' \
    '*--case[open this case file]:case file:_files -g "*.json"' \
    '*--set[set a value of the case or of the page]:key=value' \
    '--screenshot[write the window as a PNG picture and exit]:picture:_files -g "*.png"' \
    '--report[write a report of the case as PDF or HTML and exit]:report:_files -g "*.(pdf|html)"' \
    '--size[size of the window, for example 1280x800]:WxH' \
    '--theme[colours]:theme:(light dark system)' \
    '--language[language of the program]:language:(en ru)' \
    '--scale[pixels of the picture for one of the window]:factor:(1 2)' \
    '--text[size of the text in percent]:percent:(85 100 125 150 200)' \
    '(- *)'{-h,--help}'[show the options and exit]' \
    '(- *)--help-all[the same with the options of Qt]' \
    '(- *)'{-v,--version}'[show the version and exit]' \
    '*:case file:_files -g "*.json"'
