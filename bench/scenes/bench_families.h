// The families of scenes to measure accelerators on. The size alone decides a scene, to the bit on
// one machine. To add one: its maker, declared here, in a file of its own; its line in the table of
// bench_families.cpp.
#pragma once

#include <span>
#include <string_view>

#include "core/scene/scene.h"

namespace etalon::bench {

struct Family {
    std::string_view name;
    std::string_view unit;  ///< of the size: "N" primitives, or a "DEPTH"
    std::size_t usual;      ///< size where none is given
    std::size_t most;       ///< size, by what indices and memories hold
    std::string_view what;
    Scene (*make)(std::size_t size);
    int pixels = 512;  ///< along either side; fewer where a ray costs a hundred times the usual
};

std::span<const Family> families();

Scene soup(std::size_t count);
Scene spheres(std::size_t count);
Scene duplicates(std::size_t count);
Scene terrain(std::size_t count);
Scene flake(std::size_t count);
Scene stadium(std::size_t count);
Scene slivers(std::size_t count);
Scene sphereflake(std::size_t depth);
Scene mixed(std::size_t count);
Scene flat(std::size_t count);
Scene equal(std::size_t count);
Scene nan_soup(std::size_t count);
Scene hair(std::size_t count);
Scene forest(std::size_t instances);
Scene forest_copies(std::size_t instances);
Scene plaza(std::size_t instances);
Scene plaza_copies(std::size_t instances);

}  // namespace etalon::bench
