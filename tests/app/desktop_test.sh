#!/usr/bin/env bash
# desktop_test.sh RAVNOVES EXAMPLES-FOLDER: the desktop program's own command line, without a display.
set -euo pipefail
program=$1 examples=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 700 "$folder"
export XDG_RUNTIME_DIR=$folder HOME=$folder XDG_CONFIG_HOME=$folder/config LC_ALL=C.UTF-8
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM
cd "$folder"
case_file=$examples/tmz-650d.case.json

faults=0
fault() {
    printf 'FAULT: %s\n' "$*"
    faults=$((faults + 1))
}
# run ARGUMENT...: sets status, and leaves what was said in out and err.
run() {
    status=0
    "$program" "$@" >out 2>err </dev/null || status=$?
}
# rejected WORDS ARGUMENT...: ends with 2, one line on standard error that holds WORDS, no picture.
rejected() {
    local words=$1
    shift
    rm -f page.png
    run "$@"
    [ $status = 2 ] || fault "'$*' ends with $status, not 2"
    [ "$(wc -l <err)" = 1 ] || fault "'$*' does not say one line: $(cat err)"
    grep -F -- "$words" err >/dev/null || fault "'$*' does not say '$words': $(cat err)"
    [ ! -e page.png ] || fault "'$*' leaves a picture"
}
is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ]; }
# The width and the height that the picture's header states.
size_of() { od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }'; }

rejected "There is no display"
rejected "There is no display" "$case_file"

run --version
[ $status = 0 ] || fault "--version ends with $status"
grep -E '^Ravnoves [0-9]+\.[0-9]+' out >/dev/null || fault "--version says: $(cat out)"
run --help
[ $status = 0 ] || fault "--help ends with $status"
for option in --scene --case --set --screenshot --size; do
    grep -e "$option" out >/dev/null || fault "--help does not name $option"
done

# A page as a picture, the same on every run, whatever the scale of the desktop.
run --screenshot page.png --size 1000x700 --scene balance-shaft --case "$case_file"
[ $status = 0 ] || fault "--screenshot ends with $status: $(cat err)"
is_png page.png || fault "--screenshot wrote no PNG file"
[ "$(size_of page.png)" = 1000x700 ] || fault "--size 1000x700 gave $(size_of page.png)"
mv page.png first.png
QT_SCALE_FACTOR=2 QT_FONT_DPI=200 QT_QPA_PLATFORM=offscreen \
    run --screenshot=page.png --size=1000x700 "$case_file"
cmp first.png page.png || fault "two pictures of one page differ"
run --screenshot page.png --size 1000x700 --case "$case_file" --set shaft_angle_deg=120
[ $status = 0 ] || fault "--set ends with $status: $(cat err)"
if cmp -s first.png page.png; then
    fault "--set shaft_angle_deg=120 changes nothing"
fi

# On a real X server the picture is the same (its pointer rests in the middle, outside the window).
if command -v xvfb-run >/dev/null && command -v xauth >/dev/null; then
    QT_QPA_PLATFORM=xcb xvfb-run -a -s "-screen 0 2600x1600x24" "$program" \
        --screenshot page.png --size 1000x700 --case "$case_file" 2>err || fault "under X: $(cat err)"
    cmp first.png page.png || fault "the page differs between X and offscreen"
fi

rejected "missing.json" --screenshot page.png --case missing.json
head -c 100 "$program" >binary.json
rejected "binary.json" --screenshot page.png --case binary.json
sed 's/"crank_radius_mm": 46/"crank_radius_mm": -46/' "$case_file" >bad.json
rejected "bad.json: /input/crank_radius_mm: must be greater than 0, got -46" \
    --screenshot page.png --case bad.json
rejected "balance-shaft" --screenshot page.png --scene balance-shafts
rejected "--size" --screenshot page.png --size 12
for scale in nan 1e9 0 100 3 1.5 abc 2x ''; do
    rejected "--scale: must be 1 or 2" --screenshot page.png --scale "$scale"
done
rejected "--size" --screenshot page.png --size 999999x999999
rejected "--theme" --screenshot page.png --theme blue
rejected "--theme: must be light, dark or system, got" --screenshot page.png --theme ""
rejected "--language: must be one of en, ru, got xx" --screenshot page.png --language xx
rejected "--language" --screenshot page.png --language ""
# Whatever takes a value rejects an empty one.
"$program" --help >help
mapfile -t takes_value < <(sed -nE 's/^ +(--[a-z]+) <.*/\1/p' help)
[ ${#takes_value[@]} -ge 10 ] || fault "--help lists ${#takes_value[@]} options with a value"
for option in "${takes_value[@]}"; do
    [ "$option" = --screenshot ] && other=(--scene start) || other=(--screenshot page.png)
    rejected "$option" "${other[@]}" "$option" ""
    rejected "$option" "${other[@]}" "$option="
done
rejected "case: must not be empty" --screenshot page.png ""
rejected "--scale: needs --screenshot" --report page.pdf --scale 2 "$case_file"
rejected "--report: excludes --screenshot" --screenshot page.png --report page.pdf "$case_file"
rejected "--set" --screenshot page.png --set shaft_angle_deg
rejected "no_such_key" --screenshot page.png --set no_such_key=1
rejected "no/such/folder/page.png" --screenshot no/such/folder/page.png
rejected "no-such-option" --screenshot page.png --no-such-option

[ $faults = 0 ] || {
    printf '%d faults\n' "$faults"
    exit 1
}
