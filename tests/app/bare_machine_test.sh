#!/usr/bin/env bash
# bare_machine_test.sh RAVNOVES RAVNOVES-CLI EXAMPLES-FOLDER LOCALES-FOLDER: both programs where
# things are missing that every machine has: fonts, a home, a decimal point.
set -euo pipefail
desktop=$1 cli=$2 examples=$3 locales=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 700 "$folder"
export XDG_RUNTIME_DIR=$folder HOME=$folder LC_ALL=C.UTF-8 QT_QPA_PLATFORM=offscreen
unset DISPLAY WAYLAND_DISPLAY XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME
cd "$folder"
case_file=$examples/zotov-counterweight.case.json

faults=0
fault() {
    printf 'FAULT: %s\n' "$*"
    faults=$((faults + 1))
}
# picture NAME COMMAND...: the page as a picture, the program started by COMMAND.
picture() {
    local name=$1
    shift
    "$@" "$desktop" --screenshot "$name.png" --size 1000x700 --case "$case_file" >out 2>err ||
        fault "$name: no picture: $(cat err)"
}
# same NAME: that picture is the ordinary one.
same() { cmp -s plain.png "$1.png" || fault "$1: another picture"; }

picture plain env
"$cli" solve "$case_file" >plain.json

# The program brings its font.
printf '<fontconfig><dir>%s/none</dir><cachedir>%s/cache</cachedir></fontconfig>' \
    "$folder" "$folder" >fonts.conf
picture fonts env FONTCONFIG_FILE="$folder/fonts.conf"
[ "$(wc -c <fonts.png)" -gt 60000 ] || fault "without fonts the picture is empty"

# No home at all, or one that cannot be made.
for home in -uHOME HOME=/proc/none; do
    picture "home${home//\//-}" env "$home"
    same "home${home//\//-}"
    env "$home" "$cli" solve "$case_file" | cmp -s - plain.json || fault "$home: another result"
    # The window itself: still there after a second.
    status=0
    env "$home" timeout 2 "$desktop" --scene workshop >out 2>err || status=$?
    [ $status = 124 ] || fault "$home: the window ends with $status: $(cat err)"
done

# A decimal comma.
for locale in ru_RU.UTF-8 de_DE.UTF-8; do
    if ! LC_ALL=$locale LOCPATH=$locales locale -k decimal_point 2>/dev/null | grep -q '","'; then
        printf 'no locale %s here\n' "$locale"
        continue
    fi
    LC_ALL=$locale LOCPATH=$locales "$cli" solve "$case_file" | cmp -s - plain.json ||
        fault "$locale: another result"
    picture "$locale" env LC_ALL="$locale" LOCPATH="$locales"
    same "$locale"
done

status=0
"$desktop" --screenshot /proc/none.png --case "$case_file" >out 2>err || status=$?
[ $status = 2 ] || fault "a picture that cannot be written ends with $status"
[ -s err ] || fault "a picture that cannot be written is not said"

[ $faults = 0 ] || exit 1
echo "nothing is missed"
