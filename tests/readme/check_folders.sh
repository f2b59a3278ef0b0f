#!/usr/bin/env bash
# check_folders.sh SOURCE: whether README.md names every folder of core, and whether each folder that
# it names includes only what is below it in its list.
set -euo pipefail
cd "$1"

fail() {
    printf 'README.md: %s\n' "$*" >&2
    exit 1
}

mapfile -t folders < <(sed -nE 's|^([a-z_]+(/[a-z_]+)?)/ .*|\1|p' README.md)
declare -A place
for i in "${!folders[@]}"; do place[${folders[i]}]=$i; done

for folder in core/*/; do
    [[ ${place[${folder%/}]:-} ]] || fail "$folder is not in the list of folders"
done

for folder in "${folders[@]}"; do
    [[ -d $folder ]] || fail "$folder: no such folder"
    [[ $folder == app || $folder == bench ]] && continue # of both, all that the list does not name
    for included in $(grep -rhoE --include='*.h' --include='*.cpp' '^#include "[a-z_/]+/' "$folder" |
        sed -E 's|^#include "([a-z_]+(/[a-z_]+)?).*|\1|' | sort -u); do
        [[ ${place[$included]:-} ]] || included=${included%%/*}
        [[ ${place[$included]:-} ]] || fail "$folder includes $included, which is not in the list"
        ((place[$included] >= place[$folder])) || fail "$folder includes $included, which is above it"
    done
done
