#!/bin/sh
# update.sh PROGRAM: renews the pictures of README and help, so that no number in them is old. Needs
# convert of ImageMagick. Look at each.
set -eu
program=$1
here=$(dirname "$0")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 700 "$folder"
export QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR="$folder"

# shot FILE [OPTION...]: the window as it opens for a new user.
shot() {
    file=$1
    shift
    "$program" --screenshot "$file" --theme light --size 1280x800 "$@"
}

shot "$here/balance-shaft.png" --language en --scene balance-shaft
shot "$here/methods.png" --language en --scene methods

# The map alone, without form and table.
map='470x440+438+298'
for language in en ru; do
    shot "$folder/$language.png" --language $language --scene balance-shaft --set tab=map
done
convert "$folder/en.png" -crop $map +repage -colors 160 "$here/../help/balance-shaft-map.png"
convert "$folder/ru.png" -crop $map +repage -colors 160 "$here/../help/balance-shaft-map.ru.png"

# The shaft on its way from below the crank to the best place.
frame=10
for place in 150:62 130:66 112:70 98:74 86:78 76:82 68:86 62:90 57.5:94 54.5:98 53.5:102 53.1:106; do
    shot "$folder/frame-$frame.png" --language en --scene balance-shaft --set tab=map \
        --set "shaft_angle_deg=${place%:*}" --set "centre_distance_mm=${place#*:}"
    frame=$((frame + 1))
done
convert -delay 18 -loop 0 "$folder"/frame-*.png -crop 830x690+432+60 +repage +dither -colors 64 \
    '(' -clone -1 -set delay 200 ')' -layers optimize "$here/map.gif"
