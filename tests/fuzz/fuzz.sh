#!/usr/bin/env bash
# fuzz.sh [--build | --no-build] [SECONDS]: builds the fuzz targets and gives each of them so many
# seconds (60); or only builds them, or takes them as they are. What it learns stays in
# build/fuzz/corpus and is where the next run goes on. A fault ends it: the input that caused it lies
# in build/fuzz/faults, and belongs among the seeds (tests/data/fuzz) once it is mended.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../packaging/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../packaging/common.sh"

seeds_folder=$root/tests/data/fuzz
only=
case ${1:-} in --build | --no-build) only=$1 && shift ;; esac
seconds=${1:-60}
if [ "$only" != --no-build ]; then
    configure fuzz
    build fuzz
fi
[ "$only" != --build ] || exit 0
mkdir -p "$root/build/fuzz/faults"
status=0
# What Qt and the C library keep to their end is no fault.
export LSAN_OPTIONS=suppressions=$root/tests/leaks-of-libraries.txt:print_suppressions=0
for program in "$root"/build/fuzz/tests/fuzz/fuzz-*; do
    [ -f "$program" ] || continue
    name=${program##*/fuzz-}
    corpus=$root/build/fuzz/corpus/$name
    mkdir -p "$corpus"
    seeds=("$seeds_folder/$name")
    case $name in case | lines) seeds=("$seeds_folder/case" "$root/resources/examples") ;; esac
    say "$name, $seconds s"
    log=$root/build/fuzz/$name.log
    if ! (cd "$root/build/fuzz/faults" && "$program" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=3000 -max_len=40000 -close_fd_mask=1 -print_final_stats=1 \
        "$corpus" "${seeds[@]}" 2>"$log"); then
        status=1
        say "FAULT: $log"
        grep -m3 -E "ERROR|SUMMARY|runtime error" "$log" || true
    fi
    grep -E "number_of_executed_units|peak_rss" "$log" || true
done
exit $status
