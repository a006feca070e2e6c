#!/usr/bin/env bash
# scripts_test.sh SOURCE-FOLDER: the scripts parse, the package list is sound and read as written.
set -euo pipefail
cd "$1"
status=0
fault() {
    printf 'FAULT: %s\n' "$*"
    status=1
}

for script in packaging/*.sh packaging/cluster/*.sh .ci/run tests/*/*.sh; do
    bash -n "$script" || fault "$script does not parse"
done
for script in packaging/run.sh packaging/test.sh packaging/report.sh packaging/deb.sh .ci/run; do
    [ -x "$script" ] || fault "$script is not executable"
done
# grep reads to the end (no -q): a writer that it left behind would count as a failure.
packaging/run.sh --help | grep '^usage: packaging/run.sh' >/dev/null || fault "run.sh --help says nothing"
packaging/test.sh --help | grep '^usage: packaging/test.sh' >/dev/null || fault "test.sh --help says nothing"
if packaging/run.sh --no-such-option 2>/dev/null; then
    fault "run.sh takes an option that it does not know"
fi
packaging/deb.sh --help | grep '^usage: packaging/deb.sh' >/dev/null || fault "deb.sh --help says nothing"
if packaging/deb.sh --no-such-option 2>/dev/null; then
    fault "deb.sh takes an option that it does not know"
fi
if packaging/test.sh --no-such-option 2>/dev/null; then
    fault "test.sh takes an option that it does not know"
fi

. packaging/common.sh
all=$(packages_in core ui run deb test lint full benchmark)
packages_in core | grep -x cmake >/dev/null || fault "section [core] is not read"
packages_in ui | grep -x qt6-svg-dev >/dev/null || fault "section [ui] is not read"
! packages_in core | grep -i qt >/dev/null || fault "section [core] asks for Qt"
repeated=$(sort <<<"$all" | uniq -d)
[ -z "$repeated" ] || fault "listed twice: $repeated"
# Every line that is no comment and no heading is a package that some section gives out.
listed=$(sed 's/#.*//' packaging/packages.txt | awk 'NF && $1 !~ /^\[/ { print $1 }' | sort)
[ "$listed" = "$(sort <<<"$all")" ] || fault "a section of packages.txt is read by nobody"
odd=$(grep -vE '^[a-z0-9][a-z0-9.+-]+$' <<<"$all" || true)
[ -z "$odd" ] || fault "not a package name: $odd"

# What a summary shows of tests that failed.
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cat >"$log" <<'END'
        Start  1: core/a
        Start  2: core/b
1/4 Test  #1: core/a ...........   Passed    0.10 sec
        Start  3: core/c
2/4 Test  #2: core/b ...........***Failed    0.10 sec
Note: Google Test filter = X.b
[==========] Running 1 test from 1 test suite.
[ RUN      ] X.b
x_test.cpp:3: Failure

  3 stars: ***
3/4 Test  #3: core/c ...........Subprocess aborted***Exception:   0.10 sec
END
seq 100 >>"$log"
cat >>"$log" <<'END'
4/4 Test #10: core/d ...........***Skipped   0.10 sec
no
50% tests passed, 2 tests failed out of 4
The following tests FAILED:
END
told=$(failed_tests "$log")
[ "$told" = "$(printf '%s\n' 'TEST core/b' '    x_test.cpp:3: Failure' '      3 stars: ***' 'TEST core/c' &&
    seq -f '    %.0f' 15)" ] || fault "of the tests that failed it is told: $told"

if command -v dpkg-query >/dev/null; then
    [ -z "$(missing_packages bash)" ] || fault "bash is said to be missing"
    [ "$(missing_packages bash no-such-package-at-all)" = no-such-package-at-all ] ||
        fault "a missing package is not found out"
fi
exit $status
