# Compile options shared by every target, what is compiled once for all of them, and the one way a
# library or a program of Etalon is declared and installed.

include(EtalonInstall)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# ccache is used where it is installed. It caches a file with precompiled headers only if it may
# ignore that a macro could change between two compilations; here the build system defines them all.
find_program(ETALON_CCACHE ccache)
mark_as_advanced(ETALON_CCACHE)
if(ETALON_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros ${ETALON_CCACHE})
endif()

add_library(etalon_options INTERFACE)
target_link_libraries(etalon_options INTERFACE Imath::Imath fmt::fmt)
target_include_directories(etalon_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${ETALON_INSTALL_INCLUDEDIR}>)
target_compile_features(etalon_options INTERFACE cxx_std_20)
target_compile_options(etalon_options INTERFACE
  "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wno-sign-conversion>"
  # g++ 12 sees it in every string sum (its bug 105329).
  $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>>
  # Programs too, which would be given -fPIE, so that libraries and programs share precompiled headers.
  -fPIC
  # A result must be a function of the source, not of what a compiler may fuse.
  -ffp-contract=off
  # g++ 12 drops the double -> float rounding of a vectorised pair (tests/numerics guards it).
  -fno-tree-slp-vectorize)

etalon_install_library(etalon_options options)

set(ETALON_SANITIZE "" CACHE STRING "Value for -fsanitize=, e.g. address,undefined or thread")
if(ETALON_SANITIZE)
  target_compile_options(etalon_options INTERFACE
    -fsanitize=${ETALON_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    -g1) # enough for a stack with lines
  target_link_options(etalon_options INTERFACE -fsanitize=${ETALON_SANITIZE})
endif()

# With the address sanitizer -O1 compiles in .6 of the time of -O2, and the tests take as long
# (bench/NOTES.md, "The build"). A fuzzer is run for longer than it is built.
if(ETALON_SANITIZE MATCHES "address" AND NOT ETALON_FUZZ)
  string(REPLACE "-O2" "-O1" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
endif()

# The standard library checks indices and iterators where speed is not what counts.
if(ETALON_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Debug")
  target_compile_definitions(etalon_options INTERFACE $<BUILD_INTERFACE:_GLIBCXX_ASSERTIONS>)
endif()

# Headers of other libraries are precompiled: parsing them was half of the time of a build. Each source
# file still includes what it uses; a build with CMAKE_DISABLE_PRECOMPILE_HEADERS checks that. Headers
# of Etalon are not precompiled, so that a change to one rebuilds only the files that include it. JSON
# and CLI11 are not either: each file would pay 0.4 s for the first, and few files use them.
set(ETALON_PRECOMPILED
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional>
  <random> <set> <span> <sstream> <string> <string_view> <variant> <vector>
  <Imath/ImathBox.h> <Imath/ImathColor.h> <Imath/ImathMatrix.h> <Imath/ImathVec.h>
  <fmt/format.h> <fmt/ranges.h>
  <tbb/global_control.h> <tbb/info.h> <tbb/parallel_for.h> <tbb/parallel_invoke.h>)

# CMake precompiles headers only for a target with a source file.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")

# etalon_precompiled(<group> <header>...) compiles the headers once for all targets of a group.
function(etalon_precompiled group)
  add_library(etalon_precompiled_${group} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(etalon_precompiled_${group} PRIVATE etalon_options TBB::tbb)
  target_precompile_headers(etalon_precompiled_${group} PRIVATE ${ARGN})
endfunction()

# etalon_precompile(<target> <group>) makes a target use the precompiled headers of its group.
function(etalon_precompile target group)
  target_precompile_headers(${target} REUSE_FROM etalon_precompiled_${group})
  # Without this option ccache does not see which precompiled headers g++ read.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# etalon_group(<target> <file>...) compiles source files of a target as one, which reads their headers
# once. For files that take longer to read their headers than to compile, and whose anonymous
# namespaces do not clash.
option(ETALON_GROUPS "Compile the files of a group as one" ON)
function(etalon_group target)
  list(JOIN ARGN "_" group)
  string(MD5 group "${group}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ETALON_GROUPS} UNITY_BUILD_MODE GROUP)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
endfunction()

# etalon_library(<name> SOURCES <file>... [LINKS <target>...]) makes etalon_<name>, known as
# etalon::<name>. LINKS are public: they are the arrows of the architecture.
function(etalon_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS")
  add_library(etalon_${name} STATIC ${arg_SOURCES})
  add_library(etalon::${name} ALIAS etalon_${name})
  target_link_libraries(etalon_${name} PUBLIC etalon_options ${arg_LINKS})
  etalon_install_library(etalon_${name} ${name})
  etalon_precompile(etalon_${name} code)
endfunction()

# etalon_program(<name> SOURCES <file>... [LINKS <target>...]) makes the executable <name>.
function(etalon_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE etalon_options ${arg_LINKS})
  etalon_install_program(${name})
  etalon_precompile(${name} code)
endfunction()
