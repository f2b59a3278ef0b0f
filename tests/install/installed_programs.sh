#!/usr/bin/env bash
# installed_programs.sh SOURCE BINARY|PREFIX: whether the installed programs work wherever they are moved,
# for every user, and have a manual page for each command with each of its options.
source "$(dirname "$0")/installed.sh"

# A skybox of Radiance files, which OpenImageIO alone reads: the module must be found beside the
# programs.
check_render() {
    local face status=0
    mkdir faces
    for face in right left top bottom front back; do
        printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x40\x80\xc0\x80' >"faces/$face.hdr"
    done
    sed 's,^env .*,env faces,' "$1/scenes/features/skybox.p3f" >scene.p3f
    grep -q '^env faces' scene.p3f || fail "scenes/features/skybox.p3f: no line env to replace"
    etalon render scene.p3f -q --strict --spp 0 --resolution 8x6 -o image.png || fail "render failed"
    [[ -s image.png ]] || fail "no image"
    etalon serve scene.p3f -q --spp 0 --resolution 8x6 -o served.png | grep -q '^http://127' ||
        fail "serve shows no page"
    etalon-scenes tetra --size 1 -o tetra.p3f
    etalon-bench speed --list >/dev/null
    etalon render "$prefix/share/etalon/scenes/showcase.p3f" -q --strict --spp 0 --resolution 8x6 \
        -o showcase.png
    # The report renders the shipped scenes from there, among the first things.
    timeout -s INT 3 etalon-bench report --quick -o report >/dev/null 2>log || status=$?
    ((status == 124)) || fail "the report ended early, with status $status: $(cat log)"
    if grep 'scenes/' log; then fail "the report does not find the scenes that come with it"; fi
    grep -q '[^/]etalon-bench report --quick' report/index.html || fail "the report has no commands"
    if grep -o 'build/bin/etalon' report/index.html; then fail "its commands are those of a build"; fi
}

# check_page NAME COMMAND...: the page NAME.1 against the help of the command.
check_page() {
    local page=$prefix/share/man/man1/$1.1 option count=0
    [[ -s $page ]] || fail "no manual page $1.1"
    while read -r option; do
        grep -qF -- "\\fB${option//-/\\-}\\fR" "$page" || fail "$1.1: nothing about $option"
        count=$((count + 1))
    done < <("${@:2}" --help | grep -oE '^  (-[a-zA-Z], )?--[a-z-]+' | grep -oE -- '-.*' | tr -s ', ' '\n')
    ((count)) || fail "${*:2} --help: no options found"
    if command -v groff >/dev/null; then
        [[ -z $(groff -man -ww -z "$page" 2>&1) ]] || fail "$1.1: $(groff -man -ww -z "$page" 2>&1)"
    fi
}

check_pages() {
    local program command
    for program in etalon etalon-bench etalon-scenes; do
        check_page "$program" "$program"
        for command in $(commands_of "$program"); do
            check_page "$program-$command" "$program" "$command"
        done
    done
    [[ -s $prefix/share/man/man1/etalon-render.1 ]] || fail "commands_of finds no commands"
}

# What a help text names of the documentation, and what that says to call, is there to be read and run.
check_documents() {
    local document documents
    documents=$(for command in $(commands_of etalon-bench); do etalon-bench "$command" --help; done |
        tr -s ' \n' ' ' | grep -oE 'docs/[a-z/]+\.md' | sort -u)
    [[ -n $documents ]] || fail "no help text names a document"
    for document in $documents README.md docs/still_life.png; do
        [[ -s $prefix/share/doc/etalon/$document ]] || fail "$document is not installed"
    done
    { "$prefix/share/doc/etalon/scripts/slurm/submit" 2>&1 || true; } |
        grep -q '^usage: submit parts' || fail "scripts/slurm/submit does not run"
}

# What root installs, others read and run.
check_permissions() {
    local closed
    closed=$(find "$prefix" -path '*etalon*' \( ! -perm -go=r -o ! -perm -go=x \
        \( -type d -o -path '*/bin/*' -o -path '*/slurm/*' \) \))
    [[ -z $closed ]] || fail "only the owner may use: $closed"
}

check_permissions
check_render "$@"
check_pages
check_documents
