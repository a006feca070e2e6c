#!/usr/bin/env bash
# Builds Ravnoves and starts it; on a fresh Debian 12 it first installs what that takes.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
    cat <<END
usage: packaging/run.sh [--report] [-- ARGUMENT...]

Installs the Debian packages that are missing (through sudo unless root), builds the program in
build/release and starts it with the ARGUMENTs. Where there is no display, it solves the example
cases, renders their pages and writes a report with pictures to build/report instead.

  --report   write the report even where there is a display
  --help     show this text
END
}

report=no
while [ $# -gt 0 ]; do
    case $1 in
        --report) report=yes ;;
        -h | --help)
            usage
            exit 0
            ;;
        --)
            shift
            break
            ;;
        *)
            usage >&2
            fail "unknown argument '$1'; what is meant for the program goes after --"
            ;;
    esac
    shift
done

install_sections core ui run

build_release ravnoves ravnoves-cli
program=$root/build/release/bin/ravnoves
cli=$root/build/release/bin/ravnoves-cli

if [ $report = no ] && { [ $# -gt 0 ] || [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; }; then
    exec "$program" "$@"
fi

say ""
[ $report = yes ] || say "No display: solving the examples and rendering their pages instead."
exec "$root/packaging/report.sh" "$cli" "$program" "$root/resources/examples" "$root/build/report"
