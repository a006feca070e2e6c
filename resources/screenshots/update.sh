#!/bin/sh
# update.sh PROGRAM: renews the pictures of README, help and start page, so that no number in them is
# old. Needs convert of ImageMagick. Look at each.
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

shot "$here/balance-shaft.png" --language en --case "$here/../examples/with-shaft-88x75.case.json"
shot "$here/balance-shaft-map.png" --language en --set tab=map \
    --case "$here/../examples/with-shaft-88x75.case.json"
shot "$here/methods.png" --language en --scene methods --set tab=charts

# Pages without navigation and tool bar, as the start page shows them: built into the program.
page() {
    name=$1
    shift
    for theme in light dark; do
        shot "$folder/page.png" --language en --theme $theme --size 1152x737 "$@"
        convert "$folder/page.png" -crop 1047x654+105+55 +repage -resize '480x300!' -colors 64 \
            "$here/../start/$name-$theme.png"
    done
}
page balance-shaft --case "$here/../examples/with-shaft-88x75.case.json" --set tab=map
page elastic-hinge --case "$here/../examples/zotov-softer-spring.case.json" --set tab=rod-hinge
page workshop --case "$here/../examples/workshop-v8-4.25.case.json" --set tab=sheet-6
page inertia-moments --case "$here/../examples/vr5-volkswagen.case.json"
page methods --scene methods --set tab=charts
# Another one with its first case.
for icon in "$here"/../icons/scene-*.svg; do
    name=$(basename "$icon" .svg)
    name=${name#scene-}
    [ -f "$here/../start/$name-dark.png" ] || page "$name" --scene "$name"
done

# The map alone, without form, table and note.
map='470x404+438+288'
for language in en ru; do
    shot "$folder/$language.png" --language $language --scene balance-shaft --set tab=map
done
convert "$folder/en.png" -crop $map +repage -colors 160 "$here/../help/balance-shaft-map.png"
convert "$folder/ru.png" -crop $map +repage -colors 160 "$here/../help/balance-shaft-map.ru.png"
