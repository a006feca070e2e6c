#!/usr/bin/env bash
# Starts the program on an X server and a D-Bus session of its own and reads it through AT-SPI.
# usage: run.sh PROGRAM      ends with 77 where a package of packages.txt [test] is missing
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
program=$(realpath "$1")
python=/usr/bin/python3  # the one that Debian's packages of modules are for

for need in Xvfb dbus-run-session /usr/libexec/at-spi-bus-launcher; do
    if ! command -v "$need" >/dev/null; then
        echo "skipped: $need is not installed"
        exit 77
    fi
done
if ! "$python" -c 'import gi; gi.require_version("Atspi", "2.0")' 2>/dev/null; then
    echo "skipped: gir1.2-atspi-2.0 is not installed"
    exit 77
fi

home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export XDG_CONFIG_HOME=$home/config XDG_DATA_HOME=$home/data XDG_RUNTIME_DIR=$home
export QT_QPA_PLATFORM=xcb QT_LINUX_ACCESSIBILITY_ALWAYS_ON=1 LC_ALL=C.UTF-8 NO_AT_BRIDGE=0
unset WAYLAND_DISPLAY DBUS_SESSION_BUS_ADDRESS
chmod 700 "$home"
mkfifo "$home/display"
Xvfb ":$((200 + $$ % 20000))" -displayfd 3 -screen 0 1400x900x24 -nolisten tcp -noreset 3>"$home/display" 2>/dev/null &
server=$!
trap 'kill $server; rm -rf "$home"' EXIT
read -r number <"$home/display"
DISPLAY=:$number dbus-run-session -- "$python" "$here/walk.py" "$program"
