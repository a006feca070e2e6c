#!/usr/bin/env bash
# Installs, runs and removes the Debian package in a clean Debian 12, made for it by debootstrap.
set -euo pipefail

if [ $# -ne 1 ] || [ "$1" = --help ]; then
    echo "usage: packaging/try-deb.sh PACKAGE.deb    (as root; takes the network and half a gigabyte)" >&2
    exit 2
fi
package=$(realpath "$1")
examples=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../resources/examples")
clean=$(mktemp -d)
trap 'rm -rf --one-file-system "$clean"' EXIT
chmod 755 "$clean"

debootstrap --variant=minbase bookworm "$clean" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" >"$clean.log" 2>&1 || {
    tail -n 20 "$clean.log" >&2
    exit 1
}
rm -f "$clean.log"
cp "$package" "$clean/tmp/ravnoves.deb"
cp "$examples/tmz-650d.case.json" "$clean/tmp/"
# inside COMMAND…: neither a display nor anything of this machine's settings.
inside() {
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=/root chroot "$clean" "$@"
}
inside apt-get update -q >/dev/null
inside apt-get install -y -q --no-install-recommends /tmp/ravnoves.deb \
    shared-mime-info desktop-file-utils libglib2.0-bin file >"$clean/tmp/log" 2>&1 || {
    tail -n 20 "$clean/tmp/log" >&2
    exit 1
}

faults=0
# holds WHAT COMMAND…
holds() {
    local what=$1
    shift
    if "$@" >"$clean/tmp/said" 2>&1; then
        printf 'ok    %s\n' "$what"
    else
        printf 'FAULT %s\n' "$what"
        tail -n 5 "$clean/tmp/said"
        faults=$((faults + 1))
    fi
}
holds "ravnoves-cli solves a case" inside ravnoves-cli solve /tmp/tmz-650d.case.json -o /tmp/result.json
holds "ravnoves draws a page" inside ravnoves --language ru --screenshot /tmp/page.png /tmp/tmz-650d.case.json
holds "the picture is one" inside sh -c 'file /tmp/page.png | grep "PNG image data, 1280 x 800"'
type=application/x-ravnoves-case+json
holds "a case has its MIME type" inside sh -c "gio info /tmp/tmz-650d.case.json | grep 'content-type: $type'"
holds "a double click opens it with ravnoves" inside sh -c "gio mime $type | grep org.ravnoves.ravnoves.desktop"
mapfile -t files < <(inside dpkg -L ravnoves)
holds "the package has files" [ ${#files[@]} -gt 20 ]

inside apt-get purge -y -q ravnoves >"$clean/tmp/log" 2>&1
left=0
for file in "${files[@]}"; do
    if [ ! -d "$clean$file" ] && [ -e "$clean$file" ]; then
        printf 'FAULT %s is left\n' "$file"
        left=1
    fi
done
holds "nothing is left of it" [ $left = 0 ]
holds "not even of the MIME type" inside sh -c '! grep -r ravnoves /usr/share/mime /usr/share/applications'
[ $faults = 0 ]
