# What the tests of an installation begin with: $scratch, an empty folder that goes at the end, and
# in $prefix Etalon, installed and then moved.
set -euo pipefail

tests=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix="$scratch/moved here"

fail() {
    printf '%s\n' "$*" >&2
    exit 1
}

# The new programs are there, whoever was first to build them.
cmake --install "$2" --prefix "$scratch/prefix" >"$scratch/log" || fail "$(cat "$scratch/log")"
mv "$scratch/prefix" "$prefix"
mkdir "$scratch/elsewhere"
cd "$scratch/elsewhere"
export PATH="$prefix/bin:$PATH"

# Names of the commands in the help of a program.
commands_of() {
    "$1" --help | awk '/^Commands:/ { on = 1; next } /^$/ { on = 0 } on && /^  [a-z]/ { print $1 }'
}
