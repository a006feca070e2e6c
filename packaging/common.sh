# shellcheck shell=bash
# Shared by run.sh and test.sh: reads packages.txt, installs what is missing, configures and builds.
# Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages_file=$root/packaging/packages.txt

say() { printf '%s\n' "$*"; }
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# packages_in SECTION…: the packages of these sections, one per line.
packages_in() {
    local line name section=""
    while IFS= read -r line || [ -n "$line" ]; do
        line=${line%%#*}
        read -r name _ <<<"$line" || true
        case $name in
            '') ;;
            '['*']')
                section=${name#[}
                section=${section%]}
                ;;
            *)
                case " $* " in *" $section "*) printf '%s\n' "$name" ;; esac
                ;;
        esac
    done <"$packages_file"
}

# missing_packages PACKAGE…: those that dpkg does not hold installed. Asks dpkg alone: no network.
missing_packages() {
    local package status installed state name
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
    for package in "$@"; do
        status=missing
        while read -r state name; do
            [ "$name" = "$package" ] && [ "$state" = installed ] && status=installed
        done <<<"$installed"
        [ "$status" = installed ] || printf '%s\n' "$package"
    done
}

# install_sections SECTION…: makes sure that the packages of these sections are installed.
install_sections() {
    local -a wanted missing as_root=()
    mapfile -t wanted < <(packages_in "$@")
    [ ${#wanted[@]} -gt 0 ] || fail "no packages in section $* of $packages_file"
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "No apt-get here, so nothing is installed. On Debian 12 these packages are needed:"
        say "    ${wanted[*]}"
        return 0
    fi
    mapfile -t missing < <(missing_packages "${wanted[@]}")
    [ ${#missing[@]} -gt 0 ] || return 0

    say "Installing ${#missing[@]} packages that are missing: ${missing[*]}"
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "these packages are missing, and there is no sudo to install" \
            "them with; as root: apt-get install --no-install-recommends ${missing[*]}"
        say "Not root: apt-get runs through sudo."
        as_root=(sudo)
    fi
    local -a apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -q
        -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
    "${apt[@]}" update </dev/null ||
        say "The package lists could not be refreshed; trying with those at hand."
    "${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null ||
        fail "apt-get could not install: ${missing[*]}"
}

# As many compilers at once as there are cores, but each with a gibibyte of memory to itself.
build_jobs() {
    local cores memory_kib=""
    cores=$(nproc 2>/dev/null || echo 1)
    if [ -r /proc/meminfo ]; then
        memory_kib=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB$/\1/p' /proc/meminfo)
    fi
    if [ -n "$memory_kib" ] && [ $((memory_kib / 1048576)) -lt "$cores" ]; then
        cores=$((memory_kib / 1048576))
    fi
    say $((cores > 0 ? cores : 1))
}

# configure PRESET [CMAKE-ARGUMENT…]. A build folder that came with a copied checkout names another
# place on disk, which CMake rejects; it is made again.
configure() {
    local preset=$1 cache=$root/build/$1/CMakeCache.txt home
    shift
    if [ -f "$cache" ]; then
        home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")
        if [ "$home" != "$root" ]; then
            say "build/$preset was made for $home: starting it anew."
            rm -rf "$root/build/$preset"
        fi
    fi
    (cd "$root" && cmake --preset "$preset" "$@")
}

# build PRESET [TARGET…]
build() {
    local preset=$1
    shift
    (cd "$root" && cmake --build --preset "$preset" -j "$(build_jobs)" ${1:+--target "$@"})
}

# build_release TARGET…: in build/release. A build folder that has its tests on keeps them; a new one
# leaves them out, so that the programs do not need what testing them needs.
build_release() {
    if ! [ -f "$root/build/release/build.ninja" ] ||
        ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$root/build/release/CMakeCache.txt"; then
        configure release -DRAVNOVES_BUILD_TESTS=OFF
    fi
    build release "$@"
}

# failed_tests LOG: of what ctest --output-on-failure said, each test that failed: a line "TEST NAME"
# and below it, indented, the first lines of its output that tell something.
failed_tests() {
    awk -v most=15 '
        / Test +#[0-9]+: / || /^ *Start +[0-9]+: / || /^[0-9]+% tests passed/ {
            left = 0
            if (/\*\*\*/ && !/\*\*\*Skipped/) {
                sub(/^.* Test +#[0-9]+: /, "")
                print "TEST " $1
                left = most
            }
            next
        }
        left > 0 && NF && !/^(Running main|Note: Google Test filter|\[[-=]+\]|\[ RUN )/ {
            print "    " substr($0, 1, 300)
            --left
        }' "$1"
}
