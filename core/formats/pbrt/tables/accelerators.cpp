// Accelerators of pbrt-v3 and their parameters.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr std::array bvh = {choice("splitmethod", "sah", "sah|hlbvh|middle|equal"),
                            integer("maxnodeprims", 4)};
constexpr std::array kdtree = {integer("intersectcost", 80), integer("traversalcost", 1),
                               number("emptybonus", 0.5F), integer("maxprims", 1),
                               integer("maxdepth", -1)};

constexpr std::array types = {
    PluginType{Category::accelerator, "bvh", bvh},
    PluginType{Category::accelerator, "kdtree", kdtree},
};

}  // namespace

std::span<const PluginType> accelerator_types() {
    return types;
}

}  // namespace etalon::pbrt
