#!/usr/bin/env bash
# check_dev.sh SOURCE: whether ./dev refuses arguments that it does not know, rather than do what nobody
# asked for, and removes only the build folders that it is told to.
set -euo pipefail

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp "$1/dev" "$scratch"
cd "$scratch"

fail() {
    printf 'dev: %s\n' "$*" >&2
    exit 1
}

for arguments in 'clean asn' 'format --chek' 'format --check app' 'package --help' 'fuzz --secs 1' 'tset'; do
    mkdir -p build build-asan build-tsan
    # shellcheck disable=SC2086 # several arguments
    if ./dev $arguments >log 2>&1; then fail "$arguments: was accepted"; fi
    [[ $(tail -n 1 log) == "dev: "* ]] || fail "$arguments: $(cat log)"
    [[ $(echo build*) == 'build build-asan build-tsan' ]] || fail "$arguments: removed a folder"
done

./dev clean asan
[[ $(echo build*) == 'build build-tsan' ]] || fail "clean asan left $(echo build*)"
./dev clean
[[ $(echo build*) == 'build*' ]] || fail "clean left $(echo build*)"
