// The families of benchmark scenes. The size alone determines a scene, to the bit on one machine.
// To add a family: its function, declared here, in a file of its own; its line in the table of
// bench_families.cpp.
#pragma once

#include <span>
#include <string_view>

#include "core/scene/scene.h"

namespace etalon::bench {

struct Family {
    std::string_view name;
    std::string_view unit;  ///< unit of the size: "N" primitives, or a "DEPTH"
    std::size_t usual;      ///< default size
    std::size_t most;       ///< largest size, limited by indices and memory
    std::string_view what;
    Scene (*make)(std::size_t size);
    int pixels = 512;  ///< along either side; fewer if a ray costs a hundred times the usual
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
