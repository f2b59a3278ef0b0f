#!/usr/bin/env bash
# installed_completion.sh SOURCE BINARY|PREFIX SHELL: whether a shell, bash, fish or zsh, completes the
# command lines of the installed programs. Status 77 where the shell is not installed.
shell=$3
command -v "$shell" >/dev/null || exit 77
source "$(dirname "$0")/installed.sh"

# The functions NAME_candidates LINE say what a shell offers at the end of a line, a word a line.
bash_candidates() {
    read -ra COMP_WORDS <<<"${1//=/ = }"
    [[ $1 != *[\ =] ]] || COMP_WORDS+=("")
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    COMPREPLY=()
    # shellcheck source=/dev/null
    source "$prefix/share/bash-completion/completions/${COMP_WORDS[0]}"
    "_${COMP_WORDS[0]//-/_}"
    [[ -z ${COMPREPLY[*]} ]] || printf '%s\n' "${COMPREPLY[@]}"
}

fish_candidates() {
    HOME=$scratch XDG_DATA_DIRS=$prefix/share fish -c "complete -C '$1'" | cut -f 1
}

zsh_candidates() {
    zsh -f "$tests/zsh_candidates.zsh" "$prefix/share/zsh/site-functions" "$1"
}

# expect WORDS LINE: what is offered, in any order; whether with the words before it in the
# argument, as bash and fish do, or without.
expect() {
    local found expected
    found=$("${shell}_candidates" "$2" | sed -E 's/^.*[,=]//' | sort | xargs)
    expected=$(tr ' ' '\n' <<<"$1" | sort | xargs)
    [[ $found == "$expected" ]] || fail "$shell completes '$2' by '$found', not '$expected'"
}

# What no list of words completes is the name of a file: bash itself adds that to what it is given.
files() {
    [[ $shell == bash ]] || echo "$1"
}

touch image.png scene.p3f
expect "$(commands_of etalon | xargs)" "etalon "
expect "render" "etalon r"
expect "embree embree-user embree-builtin" "etalon render scene.p3f -b em"
expect "none grid bvh embree embree-user embree-builtin" "etalon render --backend="
expect "bvh" "etalon render --backend=b"
expect "none" "etalon render scene.p3f -o a.exr -b no"
expect "grid" "etalon crosscheck scene.p3f -b bvh,g"
expect "cost.boxTests cost.primitiveTests" "etalon render scene.p3f --aov N,co"
expect "pbrt p3f prt" "etalon info --format p"
expect "exr png" "etalon render scene.p3f --output-format "
expect "--seed" "etalon render scene.p3f --see"
expect "$(files image.png)" "etalon render scene.p3f -o im"
expect "$(files scene.p3f)" "etalon render sc"
expect "accuracy" "etalon-bench acc"
expect "sphereflake" "etalon-scenes sphereflake"
expect "--size" "etalon-scenes --siz"
