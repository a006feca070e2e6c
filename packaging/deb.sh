#!/usr/bin/env bash
# Makes the Debian package of the release build; on a fresh Debian 12 it first installs what that takes.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
    cat <<END_OF_TEXT
usage: packaging/deb.sh [--no-install]

Builds both programs in build/release, makes build/ravnoves_VERSION_ARCHITECTURE.deb of them and
checks it with lintian; an error of lintian is an error of this script.

  --no-install   take the packages as they are
  --help         show this text
END_OF_TEXT
}

install=yes
while [ $# -gt 0 ]; do
    case $1 in
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

[ $install = no ] || install_sections core ui run deb
build_release ravnoves ravnoves-cli icons
if ! [ -f "$root/build/release/packaging/icons/512/ravnoves.png" ]; then
    configure release # before rsvg-convert was installed
    build release icons
fi

made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
(cd "$root/build/release" && cpack -G DEB -B "$made" >"$made/log" 2>&1) || {
    cat "$made/log" >&2
    fail "cpack made no package"
}
package=$(basename "$made"/*.deb)
mv "$made/$package" "$root/build/$package"
# The package is nobody's upload: no bug of Debian's tracker asked for it.
lintian --allow-root --fail-on error --suppress-tags initial-upload-closes-no-bugs \
    "$root/build/$package"

say "$root/build/$package"
say "    sudo apt install ./build/$package"
