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
shot "$here/balance-shaft-map.png" --language en --set tab=map \
    --case "$here/../examples/with-shaft-88x75.case.json"
shot "$here/methods.png" --language en --scene methods --set tab=charts

# The map alone, without form and table.
map='470x454+438+288'
for language in en ru; do
    shot "$folder/$language.png" --language $language --scene balance-shaft --set tab=map
done
convert "$folder/en.png" -crop $map +repage -colors 160 "$here/../help/balance-shaft-map.png"
convert "$folder/ru.png" -crop $map +repage -colors 160 "$here/../help/balance-shaft-map.ru.png"
