#!/usr/bin/env bash
# installed_package.sh SOURCE BINARY|PREFIX COMPILER: whether a project finds the installed Etalon, and its
# backend and its loader work in the commands of Etalon.
source "$(dirname "$0")/installed.sh"

[[ -s $prefix/share/doc/libetalon-dev/copyright ]] || fail "libetalon-dev has no copyright file"
compiler=$3

# Every header that an installed one includes by its path must be installed too.
check_headers() {
    local header
    cd "$prefix/include/etalon"
    grep -rhoE '^#include "[^"]+"' . | sort -u | cut -d'"' -f2 | while read -r header; do
        [[ -f $header ]] || fail "$header is included but not installed"
    done
    cd - >/dev/null
}

build_project() {
    cmake -S "$1/tests/install/project" -B build -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$prefix" >log 2>&1 || fail "$(cat log)"
    if grep -q 'faulty' log; then fail "find_package(Etalon) alarms its users: $(cat log)"; fi
    cmake --build build >log 2>&1 || fail "$(cat log)"
}

run_project() {
    printf '%s\n' '0 0 0 1' '2 0 0 .5' '0 2 -1 .7' '-2 0 0 .5' '0 0 2 .3' '1 1 1 .2' >balls.txt
    build/laboratory convert balls.txt -o balls.p3f
    build/laboratory crosscheck balls.p3f -b median,bvh --rays 200 >table || fail "$(cat table)"
    grep -q '^ *median' table || fail "no median in the cross-check: $(cat table)"
    build/laboratory render balls.p3f -q --spp 2 -b median -o median.png
    build/laboratory render balls.p3f -q --spp 2 -b bvh -o bvh.png
    cmp median.png bvh.png
    if build/laboratory convert table -o none.p3f 2>log; then fail "the loader took what is no ball"; fi
    grep -q '^table:1:1: error: ' log || fail "the loader says: $(cat log)"
}

# The headers over Embree need to be told its version, which the target knows.
check_embree_headers() {
    local header
    mkdir headers
    for header in "$prefix"/include/etalon/embree_backend/*.h; do
        printf '#include "embree_backend/%s"\n' "$(basename "$header")"
    done >headers/headers.cpp
    printf 'static_assert(ETALON_EMBREE_MAJOR == RTC_VERSION_MAJOR);\n' >>headers/headers.cpp
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(Headers LANGUAGES CXX)' \
        'find_package(Etalon CONFIG REQUIRED)' 'add_library(headers OBJECT headers.cpp)' \
        'target_link_libraries(headers PRIVATE etalon::embree_backend)' >headers/CMakeLists.txt
    cmake -S headers -B headers/build -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_PREFIX_PATH="$prefix" >log 2>&1 || fail "$(cat log)"
    cmake --build headers/build >log 2>&1 || fail "$(cat log)"
}

check_headers
check_embree_headers
build_project "$1"
run_project
