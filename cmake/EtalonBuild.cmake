# Compile options shared by every target, and the one way a library of Etalon is declared.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

add_library(etalon_options INTERFACE)
target_include_directories(etalon_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(etalon_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> # g++ 12 sees it in every string sum (its bug 105329)
  # A result must be a function of the source, not of what a compiler may fuse.
  -ffp-contract=off
  # g++ 12 drops the double -> float rounding of a vectorised pair (tests/numerics guards it).
  -fno-tree-slp-vectorize)

set(ETALON_SANITIZE "" CACHE STRING "Value for -fsanitize=, e.g. address,undefined or thread")
if(ETALON_SANITIZE)
  target_compile_options(etalon_options INTERFACE
    -fsanitize=${ETALON_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(etalon_options INTERFACE -fsanitize=${ETALON_SANITIZE})
endif()

# etalon_library(<name> SOURCES <file>... [LINKS <target>...]) makes etalon_<name>, known as
# etalon::<name>. LINKS are public: they are the arrows of the architecture.
function(etalon_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS")
  add_library(etalon_${name} STATIC ${arg_SOURCES})
  add_library(etalon::${name} ALIAS etalon_${name})
  target_link_libraries(etalon_${name} PUBLIC etalon_options ${arg_LINKS})
endfunction()
