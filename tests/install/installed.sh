# What the tests of an installation begin with: $scratch, an empty folder that goes at the end, and
# $prefix, where Etalon is installed. The second argument is that, or a build folder: then Etalon is
# installed from there, and the installation moved.
set -euo pipefail

tests=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
    printf '%s\n' "$*" >&2
    exit 1
}

install_and_move() {
    prefix="$scratch/moved here"
    (umask 022 && cmake --install "$1" --prefix "$scratch/prefix") >"$scratch/log" ||
        fail "$(cat "$scratch/log")"
    mv "$scratch/prefix" "$prefix"
}

prefix=$2
[[ ! -e $2/cmake_install.cmake ]] || install_and_move "$2"
mkdir "$scratch/elsewhere"
cd "$scratch/elsewhere"
export PATH="$prefix/bin:$PATH"

# Names of the commands in the help of a program.
commands_of() {
    "$1" --help | awk '/^Commands:/ { on = 1; next } /^$/ { on = 0 } on && /^  [a-z]/ { print $1 }'
}
