#!/usr/bin/env bash
# run_examples.sh SOURCE BINARY DOCUMENT: whether what a document tells its reader is so.
#
# Every ```sh block that uses build/bin runs, in order and in one shell, in a scratch folder that
# looks like the project's, with BINARY as its build; the first command that fails ends the test.
# The commands of ./dev that stand in any ```sh block must exist, and links must lead to a file and,
# where they name one, to a heading in it.
set -euo pipefail

source=$1 binary=$2 document=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
    printf '%s: %s\n' "$document" "$*" >&2
    exit 1
}

# The document with every line blanked that is not in an ```sh block matching $1, so that the line
# numbers of what runs are those of the document.
blocks() {
    awk -v wanted="$1" '
        function flush() {
            for (i = 1; i <= lines; ++i) print block ~ wanted ? line[i] : ""
            lines = 0; block = ""
        }
        inside && /^```/ { inside = 0; flush(); print ""; next }
        inside { line[++lines] = $0; block = block "\n" $0; next }
        /^```sh$/ { inside = 1 }
        { print "" }
    ' "$source/$document"
}

lay_out() {
    local entry
    for entry in "$source"/*; do
        [[ $(basename "$entry") == build* ]] || ln -s "$entry" "$scratch"
    done
    ln -s "$binary" "$scratch/build"
}

check_dev_commands() {
    local known command
    known=$("$source/dev" help)
    for command in $(blocks . | sed -n 's|^\./dev \([a-z]*\).*|\1|p'); do
        grep -q "^  $command " <<<"$known" || fail "./dev $command: no such command"
    done
}

# The anchors that GitHub gives the headings of a file.
anchors() {
    awk '
        /^```/ { inside = !inside }
        inside || !/^#+ / { next }
        {
            sub(/^#+ +/, ""); anchor = tolower($0)
            gsub(/[^a-z0-9 _-]/, "", anchor); gsub(/ /, "-", anchor)
            print anchor (seen[anchor]++ ? "-" seen[anchor] - 1 : "")
        }
    ' "$1"
}

check_links() {
    local folder link file
    folder=$(dirname "$source/$document")
    # shellcheck disable=SC2013 # links have no spaces
    for link in $(grep -o ']([^)]*' "$source/$document" | cut -c 3- | grep -v '^https\?:'); do
        file=$folder/${link%%#*}
        [[ $link != '#'* ]] || file=$source/$document
        [[ -e $file ]] || fail "$link: no such file"
        [[ $link != *'#'* ]] || anchors "$file" | grep -xF -- "${link#*#}" >/dev/null ||
            fail "$link: no such heading"
    done
}

run_blocks() {
    local script=$scratch/examples
    blocks 'build/bin/' >"$script"
    (cd "$scratch" && bash -euxo pipefail "$script" </dev/null) || fail "an example failed, see above"
}

lay_out
check_dev_commands
check_links
run_blocks
