#!/usr/bin/env bash
# Runs a study in shards by GNU parallel, on this machine or on several, and puts them together.
set -euo pipefail

usage() {
    cat <<END
usage: study-parallel.sh [--hosts FILE] CASE SHARDS RESULT [OPTION-OF-PARALLEL...]

Solves the study of the case file CASE in SHARDS parts (at most 1024), RESULT.K.part, one process for
each core, and writes RESULT. Parts that are there are not computed again: after a fault run the same command.

  --hosts FILE  the hosts, one a line, as parallel --sshloginfile has them: "8/host" takes eight
                processes, ":" is this machine. The case goes there and the parts come back by rsync,
                which every host needs; give the files that the case names by --basefile FILE after
                RESULT.

RAVNOVES_CLI says which program to run, otherwise ravnoves-cli.
END
}

hosts=()
case ${1:-} in
    -h | --help)
        usage
        exit 0
        ;;
    --hosts)
        hosts=(--sshloginfile "${2:?}")
        shift 2
        ;;
esac
if [ $# -lt 3 ]; then
    usage >&2
    exit 2
fi
file=$1 shards=$2 result=$3
shift 3
cli=${RAVNOVES_CLI:-ravnoves-cli}
if [ ${#hosts[@]} -gt 0 ]; then
    hosts+=(--basefile "$file" --return "$result.{}.part" --cleanup)
fi

left() {
    local k
    for k in $(seq "$shards"); do
        [ -e "$result.$k.part" ] || printf '%s\n' "$k"
    done
}
left | parallel -q --will-cite "${hosts[@]}" "$@" \
    "$cli" study "$file" --threads 1 --shard "{}/$shards" -o "$result.{}.part"

mapfile -t parts < <(seq -f "$result.%.0f.part" "$shards")
"$cli" study --merge "${parts[@]}" -o "$result"
rm -f -- "${parts[@]}"
