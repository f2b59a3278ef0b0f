#!/usr/bin/env bash
# on_bare_debian.sh SUITE [PACKAGES]: whether the packages of Etalon install on a bare Debian,
# bookworm or trixie, and pass there what ctest holds an installation to. As root, with debootstrap
# and a network. PACKAGES is a folder with packages made on that Debian; without it they are made
# first, by ./dev package on a Debian of their own.
set -euo pipefail

suite=$1
packages=${2-}
source=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT

# bare NAME: a Debian with the smallest set of packages, in a folder of that name.
bare() {
    debootstrap --variant=minbase "$suite" "$scratch/$1" >"$scratch/log" || {
        tail "$scratch/log"
        return 1
    }
}

# inside NAME COMMAND: runs a shell's command there, with a /proc and a /dev, and says so.
inside() {
    local root=$scratch/$1
    printf '%s, %s: %s\n' "$suite" "$1" "$2"
    root=$root command=$2 unshare --mount bash -euc '
        mount -t proc proc "$root/proc"
        mount --rbind /dev "$root/dev"
        exec chroot "$root" env -i PATH="$PATH" HOME=/root DEBIAN_FRONTEND=noninteractive \
            bash -euo pipefail -c "$command"' >"$scratch/log" 2>&1 || {
        tail -n 40 "$scratch/log"
        return 1
    }
}

# Packages must not depend on the umask of who makes them.
make_packages() {
    bare maker
    (umask 077 && git clone -q "$source" "$scratch/maker/etalon")
    inside maker "umask 077 && /etalon/dev package"
    packages=$scratch/maker/etalon/build/packages
}

# No build tree, no compiler: only the tests, the scene that they render, and the packages.
put_tests() {
    mkdir -p "$scratch/user/tests/scenes" "$scratch/user/tests/tests" "$scratch/user/packages"
    cp -r "$source/scenes/features" "$scratch/user/tests/scenes"
    cp -r "$source/tests/install" "$scratch/user/tests/tests"
    cp "$packages"/*.deb "$scratch/user/packages"
}

install="apt-get install -y --no-install-recommends"
tests=/tests/tests/install/installed

[[ -n $packages ]] || make_packages
bare user
put_tests
inside user "apt-get update && $install /packages/etalon_*.deb"
inside user "${tests}_programs.sh /tests /usr"
inside user "$install man-db bash-completion fish zsh"
inside user "MANWIDTH=80 man etalon-render >page; grep -q -- '--backend NAME' page"
inside user "sed '/^EXAMPLES/,/^EXIT/d' page | { ! grep -E '.{81}'; }" # commands are not broken
inside user "source /usr/share/bash-completion/bash_completion; _completion_loader etalon || ((\$? == 124)); complete -p etalon"
for shell in bash fish zsh; do inside user "${tests}_completion.sh /tests /usr $shell"; done
inside user "$install g++ cmake ninja-build /packages/libetalon-dev_*.deb"
inside user "${tests}_package.sh /tests /usr c++"
printf '%s: all passed\n' "$suite"
