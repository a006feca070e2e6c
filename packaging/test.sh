#!/usr/bin/env bash
# Builds Ravnoves and passes all its tests; on a fresh Debian 12 it first installs what that takes.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
    cat <<END
usage: packaging/test.sh [--quick | --full] [--no-install]

  1. core-only    core and the command line with Qt hidden from CMake: build, tests; core's tests and
                  a short fuzz once more, with a core under sanitizers
  2. release      the whole program, warnings are errors: build, its other tests (offscreen)
  3. lint         shellcheck over the scripts; what the desktop reads; the Debian package
  4. with --full  the benchmarks: build; address and undefined-behaviour sanitizers over everything;
                  clang-tidy; runs in 50 to 300 MB of memory; a minute of fuzzing for each reader,
                  random cases of each scene, fifty formulas changed one at a time, the share
                  of lines that the tests reach; 500 kills of a window that saves; a long day in a
                  window; the worker threads under the thread sanitizer

  --quick        stages 1 and 2 only
  --full         stage 4 too (slow)
  --no-install   take the packages as they are
  --help         show this text

Exits with 0 only if every stage passed.
END
}

quick=no full=no install=yes
while [ $# -gt 0 ]; do
    case $1 in
        --quick) quick=yes ;;
        --full) full=yes ;;
        --no-install) install=no ;;
        -h | --help)
            usage
            exit 0
            ;;
        *)
            usage >&2
            fail "unknown argument '$1'"
            ;;
    esac
    shift
done

# The tests see neither the user's display nor the user's settings, and the same scale everywhere.
export QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8
unset QT_FONT_DPI QT_SCALE_FACTOR DISPLAY WAYLAND_DISPLAY
export XDG_CONFIG_HOME=$root/build/test-home/config XDG_DATA_HOME=$root/build/test-home/data
export UBSAN_OPTIONS=print_stacktrace=1

# What the stages leave: a line for each, how many tests passed, failed and were skipped, and which
# failed, with the beginning of what they said.
notes=$(mktemp -d)
trap 'rm -rf "$notes"' EXIT
touch "$notes/stages" "$notes/failed" "$notes/counts" "$notes/tests"

heading() { printf '\n==== %s ====\n' "$*"; }

# stage NAME COMMAND…: runs it, notes its time and outcome, goes on after a failure.
stage() {
    local name=$1 started=$SECONDS outcome=ok
    shift
    heading "$name"
    "$@" || outcome=FAILED
    [ $outcome = ok ] || printf '%s\n' "$name" >>"$notes/failed"
    printf '%-34s %-7s %4d s\n' "$name" $outcome $((SECONDS - started)) >>"$notes/stages"
    [ $outcome = ok ]
}

# beside LANE LANE: two functions of stages that take one core each; what they say comes lane by lane.
beside() {
    local lane
    for lane in "$@"; do
        "$lane" >"$notes/$lane.log" 2>&1 &
    done
    wait
    for lane in "$@"; do
        cat "$notes/$lane.log"
    done
}

# run_tests PRESET [CTEST-ARGUMENT…]. Counts from ctest's own summary; a skipped test, which ctest
# calls passed, is counted apart.
run_tests() {
    local preset=$1 log=$root/build/$1/tests.log status=0 failed total skipped
    shift
    # One more than there are cores: some tests wait for what they have killed, locked or drawn.
    (cd "$root" && ctest --preset "$preset" -j "$(($(nproc) + 1))" --no-tests=error "$@") | tee "$log" || status=1
    failed_tests "$log" >>"$notes/tests"
    read -r failed total < <(sed -n \
        's/^.*tests passed, \([0-9]*\) tests failed out of \([0-9]*\)$/\1 \2/p' "$log") || true
    if [ -z "${total:-}" ]; then
        say "ctest did not say how many tests ran."
        return 1
    fi
    skipped=$(grep -c '(Skipped)$' "$log" || true)
    printf '%d %d %d\n' $((total - failed - skipped)) "$failed" "$skipped" >>"$notes/counts"
    return $status
}

build_and_test() {
    local preset=$1
    shift
    stage "$preset: configure" configure "$preset" -DRAVNOVES_BUILD_TESTS=ON "$@" || return 0
    stage "$preset: build" build "$preset" || return 0
    stage "$preset: tests" run_tests "$preset" || return 0
}

lint_sources() {
    stage "lint: configure" configure tidy || return 0
    stage "lint: clang-tidy" build tidy || return 0
}

# Some hundred thousand cases, damaged and with any numbers in them, by the core-only build.
run_random_cases() {
    "$root/build/core-only/tests/fuzz/fuzz-case" --copies 50000 \
        "$root/resources/examples" "$root/tests/data/fuzz/case"
}

# Each test program of a preset, whole: where a process for each test would take most of the time to
# start, and to write what it counted.
run_programs() {
    local build=$root/build/$1 status=0 logs passed
    local -x LOCPATH=$build/locales
    find "$build/tests" -name 'test-*.log' -delete
    # shellcheck disable=SC2016 # the shell of each program expands it
    find "$build/tests" -type f -name 'test-*' ! -name '*-sanitized' -perm -u+x -print0 |
        xargs -0 -P "$(nproc)" -I '{}' sh -c '"$0" --gtest_brief=1 >"$0.log" 2>&1 || {
            tail -n 60 "$0.log"; echo "$(basename "$0") failed"; exit 1; }' '{}' || status=1
    logs=$(find "$build/tests" -name 'test-*.log' -exec cat {} +)
    sed -n 's/^\[  FAILED  \] \(.*\) ([0-9]* ms)$/TEST \1/p' <<<"$logs" >>"$notes/tests"
    passed=$(sed -n 's/^\[  PASSED  \] \([0-9]*\) tests*\..*/\1/p' <<<"$logs" |
        awk '{ n += $1 } END { print n + 0 }')
    say "$passed tests passed"
    printf '%d %d %d\n' "$passed" "$(grep -c '^\[  FAILED  \] .*ms)$' <<<"$logs" || true)" \
        "$(grep -c '^\[  SKIPPED \] .*ms)$' <<<"$logs" || true)" >>"$notes/counts"
    [ "$passed" -gt 0 ] || status=1
    return $status
}

# All under address and undefined-behaviour sanitizers: the test programs, and what ctest runs beside.
check_memory() {
    local -x LSAN_OPTIONS=suppressions=$root/tests/leaks-of-libraries.txt:print_suppressions=0
    stage "asan-ubsan: configure" configure asan-ubsan -DRAVNOVES_BUILD_TESTS=ON || return 0
    stage "asan-ubsan: build" build asan-ubsan || return 0
    stage "asan-ubsan: test programs" run_programs asan-ubsan || true
    stage "asan-ubsan: programs, scripts" run_tests asan-ubsan \
        -R '^(app/(readme|desktop|bare)|fuzz/|threads/|ui/accessibility/)' || true
}

# What the tests reach, of core and of what the pages show. A program whose files are limited cannot
# write its counts.
run_coverage() {
    local -x GTEST_FILTER='-InheritedState.*'
    find "$root/build/coverage" -name '*.gcda' -delete
    run_programs coverage || return 1
    "$root/tests/coverage/coverage.py" "$root/build/coverage" --folder core=97 \
        --folder 'ui/*/model=90'
}

# Killed while they save, by the release's own tests.
run_kills() {
    local -x RAVNOVES_KILLS=500
    "$root/build/release/tests/ui/test-ui-shell" --gtest_filter='KilledWindow.*'
}

# Builds what it changes; nothing beside it may build from the sources.
change_formulas() {
    stage "mutations" "$root/tests/mutations/mutate.py" || true
    stage "500 kills" run_kills || true
}

# In any memory from 50 to 300 MB.
run_in_little_memory() {
    # shellcheck disable=SC2046 # numbers
    bash "$root/tests/app/memory_test.sh" "$root" "$root/build/core-only/bin/ravnoves-cli" $(seq 50 300)
}

feed_numbers() {
    stage "little memory" run_in_little_memory || true
    stage "random cases" run_random_cases || true
    stage "fuzz" "$root/tests/fuzz/fuzz.sh" --no-build 60 || true
    # Slider moves, cases opened and closed, animation: memory stays.
    stage "long use" "$root/build/release/tests/ui/shell/long-use" || true
}

# A random layout of addresses is none that the sanitizer of gcc 12 can take.
run_threads() {
    local paths=$root/build/tsan/tests/threads/worker-paths
    local -x TSAN_OPTIONS="suppressions=$root/tests/threads/of-qt.supp"
    TSAN_OPTIONS+=" ignore_noninstrumented_modules=1 second_deadlock_stack=1"
    if setarch "$(uname -m)" -R "$paths" --race >/dev/null 2>&1; then
        say "The sanitizer does not see a race that is there."
        return 1
    fi
    setarch "$(uname -m)" -R "$paths"
}

check_threads() {
    stage "tsan: configure" configure tsan || return 0
    stage "tsan: build" build tsan || return 0
    stage "tsan: worker paths" run_threads || true
}

measure_coverage() {
    stage "coverage: configure" configure coverage || return 0
    stage "coverage: build" build coverage || return 0
    stage "coverage: tests, lines reached" run_coverage || true
}

lint_scripts() {
    if ! command -v shellcheck >/dev/null; then
        say "shellcheck is not installed."
        return 1
    fi
    (cd "$root" && shellcheck -x packaging/*.sh packaging/cluster/*.sh .ci/run tests/*/*.sh)
}

lint_desktop() {
    local name=org.ravnoves.ravnoves status=0
    desktop-file-validate "$root/packaging/desktop/$name.desktop" || status=1
    appstreamcli validate --no-net "$root/build/release/packaging/$name.metainfo.xml" || status=1
    return $status
}

sections=(core ui run test)
[ $quick = yes ] || sections+=(lint deb)
[ $full = no ] || sections+=(full benchmark)
[ $install = no ] || stage "packages" install_sections "${sections[@]}"

build_and_test core-only
# What core-only has just built and tested is not built and tested again.
archive=$root/build/core-only/core/libravnoves-core.a
! grep -qx 'core-only: build' "$notes/failed" && [ -f "$archive" ] || archive=
build_and_test release -DRAVNOVES_BUILD_CORE_TESTS=OFF -DRAVNOVES_CORE_ARCHIVE="$archive" \
    -DRAVNOVES_BUILD_BENCHMARKS="$full"
if [ $quick = no ]; then
    stage "lint: scripts" lint_scripts || true
    stage "lint: desktop entry, metainfo" lint_desktop || true
    stage "lint: Debian package" "$root/packaging/deb.sh" --no-install || true
fi
if [ $full = yes ]; then
    stage "fuzz: build" "$root/tests/fuzz/fuzz.sh" --build || true
    stage "long use: build" build release long-use || true
    beside change_formulas feed_numbers
    check_threads
    check_memory
    measure_coverage
    lint_sources
fi

# Whoever goes on in build/release compiles core there, of what its sources are then.
[ ! -f "$root/build/release/CMakeCache.txt" ] || configure release -DRAVNOVES_CORE_ARCHIVE= \
    -DRAVNOVES_BUILD_BENCHMARKS=no >/dev/null

heading "summary"
# All that is seen of a run may be its last lines.
head -n 160 "$notes/tests"
cat "$notes/stages"
awk '{ passed += $1; failed += $2; skipped += $3 }
    END { if (skipped) printf "%d skipped\n", skipped; printf "%d passed, %d failed\n", passed, failed }' \
    "$notes/counts"
if [ -s "$notes/tests" ]; then
    printf 'failed tests: %s\n' "$(sed -n 's/^TEST //p' "$notes/tests" | head -n 40 | paste -sd ' ')"
fi
if [ -s "$notes/failed" ]; then
    printf 'FAILED: %s\n' "$(paste -sd ',' "$notes/failed")"
    exit 1
fi
