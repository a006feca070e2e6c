#!/usr/bin/env bash
# Solves every example case, renders its page, writes its report as PDF, and a page with all of them.
# Needs no display.
set -euo pipefail

if [ $# -ne 4 ]; then
    echo "usage: report.sh RAVNOVES-CLI RAVNOVES EXAMPLES-FOLDER REPORT-FOLDER" >&2
    exit 2
fi
cli=$1 program=$2 examples=$3 report=$4
XDG_RUNTIME_DIR=$(mktemp -d) # private, or Qt complains
trap 'rm -rf "$XDG_RUNTIME_DIR"' EXIT
export XDG_RUNTIME_DIR QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8
unset QT_FONT_DPI QT_SCALE_FACTOR

# field NAME FILE: a top-level string of a case file.
field() { sed -n "s/.*\"$1\"[[:space:]]*:[[:space:]]*\"\([^\"]*\)\".*/\1/p" "$2" | head -n 1; }
escape() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g'; }

# The result with every long list of numbers folded into one line that says how many it holds.
fold_lists() {
    awk '
        function flush() { if (held != "") printf "%s", held; held = "" }
        /\[$/ { flush(); held = $0 "\n"; head = $0; count = 0; first = ""; next }
        held != "" && /^ *-?[0-9.eE+-]+,?$/ {
            value = $0; gsub(/[ ,]/, "", value)
            if (count == 0) first = value
            last = value; count++; held = held $0 "\n"; next
        }
        held != "" && /^ *\],?$/ {
            tail = $0; sub(/^ */, "", tail)
            if (count > 4) { printf "%s %s, ... %s %s   (%d values)\n", head, first, last, tail, count; held = "" }
            else { held = held $0 "\n"; flush() }
            next
        }
        { flush(); print }
        END { flush() }'
}

mkdir -p "$report"
rm -f "$report"/*.png "$report"/*.pdf "$report"/*.result.json "$report"/index.html
page=$report/index.html
failures=0
{
    cat <<'END'
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>Ravnoves: the example cases</title>
<style>
body { font: 15px/1.45 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; }
img { width: 100%; border: 1px solid #bbb; }
pre { background: #f4f4f4; color: #111; padding: .8em; overflow: auto; max-height: 28em; }
.bad { color: #b00020; }
</style>
</head>
<body>
<h1>Ravnoves: the example cases</h1>
END
} >"$page"

for case_file in "$examples"/*.case.json; do
    [ -f "$case_file" ] || continue
    name=$(basename "$case_file" .case.json)
    scene=$(field scene "$case_file")
    title=$(field title "$case_file")
    result=$report/$name.result.json
    picture=$report/$name.png
    status=solved
    if ! complaint=$("$cli" solve "$case_file" -o "$result" 2>&1); then
        status=failed
        failures=$((failures + 1))
    fi
    drawn=yes
    if ! drawing_complaint=$("$program" --screenshot "$picture" --scene "$scene" \
        --case "$case_file" 2>&1) || ! [ -s "$picture" ]; then
        drawn=no
        failures=$((failures + 1))
    fi
    mapped=no
    if [ "$scene" = balance-shaft ] && [ $drawn = yes ]; then
        if drawing_complaint=$("$program" --screenshot "$report/$name.map.png" --scene "$scene" \
            --case "$case_file" --set tab=map 2>&1) && [ -s "$report/$name.map.png" ]; then
            mapped=yes
        else
            drawn=no
            failures=$((failures + 1))
        fi
    fi
    paper=no
    if [ $status = solved ]; then
        if drawing_complaint=$("$program" --report "$report/$name.pdf" --case "$case_file" 2>&1) &&
            [ -s "$report/$name.pdf" ]; then
            paper=yes
        else
            drawn=no
            failures=$((failures + 1))
        fi
    fi
    {
        printf '<h2>%s</h2>\n' "$(printf '%s' "${title:-$name}" | escape)"
        printf '<p>Module %s, case %s</p>\n' "$scene" "$(basename "$case_file" | escape)"
        if [ $drawn = yes ]; then
            printf '<p><img src="%s.png" alt="The page of this case"></p>\n' "$name"
        else
            printf '<p class="bad">The page was not rendered: %s</p>\n' \
                "$(printf '%s' "$drawing_complaint" | escape)"
        fi
        if [ $mapped = yes ]; then
            printf '<p><img src="%s.map.png" alt="The map of the shaft'"'"'s places"></p>\n' "$name"
            printf '<p>Change in the range of the moment on the mounts vs. no shaft: blue where the shaft '
            printf 'helps, orange where it harms, hatched where it does not fit. Proven optima: '
            printf '<code>best_position</code> and, with clearance, <code>best_position_buildable</code>.</p>\n'
        fi
        if [ $paper = yes ]; then
            printf '<p><a href="%s.pdf">Report of this case</a> (PDF): inputs, results, plots, formulas, ' "$name"
            printf 'validation</p>\n'
        fi
        if [ $status = solved ]; then
            printf '<details><summary>Result (<a href="%s.result.json">all of it</a>)</summary>\n' "$name"
            printf '<pre>%s</pre></details>\n' "$(fold_lists <"$result" | escape)"
        else
            printf '<p class="bad">Not solved: %s</p>\n' "$(printf '%s' "$complaint" | escape)"
        fi
    } >>"$page"

    printf '  %-22s %-16s %s' "$name" "$scene" "$status"
    if [ $drawn = yes ]; then printf ', %s.png' "$name"; else printf ', no picture'; fi
    if [ $mapped = yes ]; then printf ', %s.map.png' "$name"; fi
    if [ $paper = yes ]; then printf ', %s.pdf' "$name"; fi
    printf '\n'
    [ $status = solved ] || printf '    %s\n' "$complaint"
    [ $drawn = yes ] || printf '    %s\n' "$drawing_complaint"
done
# The page that has no case: what the methods cost and where they fail, measured on this machine.
picture=$report/methods.png
if complaint=$("$program" --screenshot "$picture" --scene methods 2>&1) && [ -s "$picture" ]; then
    {
        printf '<h2>Methods: speed, accuracy, limits</h2>\n'
        printf '<p><img src="methods.png" alt="The page of the methods"></p>\n'
    } >>"$page"
    printf '  %-22s %-16s measured, methods.png\n' methods methods
else
    failures=$((failures + 1))
    printf '<p class="bad">The page of the methods was not rendered: %s</p>\n' \
        "$(printf '%s' "$complaint" | escape)" >>"$page"
    printf '  %-22s %-16s no picture\n    %s\n' methods methods "$complaint"
fi
printf '</body>\n</html>\n' >>"$page"

printf '\nReport: %s\n' "$page"
if [ $failures -ne 0 ]; then
    printf '%d of its parts failed.\n' "$failures" >&2
    exit 1
fi
