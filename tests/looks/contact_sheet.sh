#!/bin/sh
# Renders every page with each of its tabs, at all sizes of window and text, in both themes and languages,
# into one contact sheet for each page and look. Needs montage of ImageMagick.
#
#   tests/looks/contact_sheet.sh PROGRAM FOLDER [SCENE…]
set -eu
program=$1
folder=$2
shift 2
export QT_QPA_PLATFORM=offscreen
# A scene that is none makes the program name those that there are.
# shellcheck disable=SC2046 # words
[ $# -gt 0 ] || set -- $("$program" --screenshot /dev/null --scene '?' 2>&1 |
    sed -n 's/^--scene: must be one of start, \(.*\), got ?$/\1/p' | tr -d ,)
mkdir -p "$folder/single"

# Size, percent of the text, scale factor.
looks='1024x700:100:1 1280x800:100:1 1920x1080:100:1 1920x1080:200:1 1360x850:200:1 960x540:100:2'

for scene in "$@"; do
    # A tab that is none makes the program name those that there are.
    tabs=$("$program" --scene "$scene" --set tab=? --screenshot /dev/null 2>&1 |
        sed -n 's/.*tab must be one of \(.*\), got ?$/\1/p' | tr -d ,)
    for look in $looks; do
        size=${look%%:*}
        scale=${look##*:}
        text=${look#*:}
        text=${text%:*}
        for theme in light dark; do
            for language in en ru; do
                name=$scene-$size-$text-x$scale-$theme-$language
                for tab in ${tabs:-first}; do
                    set --
                    [ "$tab" = first ] || set -- --set "tab=$tab"
                    "$program" --scene "$scene" "$@" \
                        --size "$size" --text "$text" --scale "$scale" --theme "$theme" \
                        --language "$language" --screenshot "$folder/single/$name-$tab.png"
                done
                montage "$folder/single/$name"-*.png -tile 3x -geometry '960x+6+6' \
                    "$folder/$name.png"
                echo "$folder/$name.png"
            done
        done
    done
done
