#!/usr/bin/env bash
# memory_test.sh SOURCE-FOLDER RAVNOVES-CLI [MEGABYTES…]: in however little memory, a command ends by
# itself, and a batch answers each line.
set -euo pipefail
examples=$1/resources/examples cli=$2
shift 2
[ $# -gt 0 ] || set -- 50 110 300
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ulimit -c 0

faults=0
fault() {
    printf 'FAULT: %s\n' "$*"
    faults=$((faults + 1))
}

small=$(tr -d '\n' <"$examples/tmz-650d.case.json")
printf '%s\n' "$small" >small.json
# begin_study SAMPLES METHOD
study() { printf '%s, "study": {"vary": {"/crank_radius_mm": {"plus_minus": 0.02}}, "watch":
    {"/metrics/M_ups/range_Nm": {}, "/optimum/rms/rms_Nm": {}}, "samples": %s, "method": "%s"}}' \
    "${small%\}}" "$1" "$2"; }
study 2000 sobol >study.json
# Documents of many values: all at once in one list, and in little pieces.
list() { printf '{"format": "ravnoves-case", "version": 1, "scene": "balance-shaft", "input": [%s0]}\n' \
    "$(yes "$1," | head -n "$2" | tr -d '\n')"; }
list 0 3000000 >flat.json
list '{"a":[1]}' 400000 >pieces.json
list '"a text that is too long to be kept in place"' 300000 >texts.json
{ cat flat.json && printf '%s\n' "$small" && cat pieces.json texts.json && printf '%s\n' "$small"; } >lines.txt

# answers FILE: each line is an answer, the second and the last a result.
answers() {
    [ "$(grep -c '^{' "$1")" = 5 ] && [ "$(wc -l <"$1")" = 5 ] &&
        sed -n '2p;5p' "$1" | grep -c '"format":"ravnoves-result"' | grep -x 2 >/dev/null
}
said=0
for megabytes; do
    while read -r -a words; do
        status=0
        rm -f out
        (
            ulimit -v $((1024 * megabytes))
            exec "$cli" "${words[@]}"
        ) <lines.txt >answers 2>err || status=$?
        [ $status = 0 ] || [ $status = 2 ] ||
            fault "'${words[*]}' in $megabytes MB ends with $status: $(head -c 200 err)"
        [ $status = 0 ] || [ "$(wc -l <err)" = 1 ] ||
            fault "'${words[*]}' in $megabytes MB says: $(head -c 200 err)"
        ! grep 'needs more memory than available' answers err >/dev/null || said=$((said + 1))
        [ "${words[1]}" != --batch ] || answers answers ||
            fault "a batch in $megabytes MB says: $(cut -c 1-100 answers err)"
    done <<'END'
solve small.json
solve flat.json
solve pieces.json
solve texts.json
solve --batch
study study.json
study study.json --threads 16 -o out
study flat.json
study --merge flat.json pieces.json
END
done
# More threads than there are cores leave as much memory for the work.
"$cli" study study.json >few
(
    ulimit -v $((200000 + 80000 * $(nproc --all)))
    exec "$cli" study study.json --threads 1024
) >many 2>&1 || fault "1024 threads: $(head -c 200 many)"
cmp -s few many || fault "1024 threads give other numbers"
[ $said -gt 0 ] || fault "nothing needed more memory than there was"
[ $faults -eq 0 ] || exit 1
