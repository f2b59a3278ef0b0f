#pragma once

#include <vector>

#include "core/intersect/bounded.h"

namespace etalon {

/// Instances that are tiny beside the scene and near each other.
struct TinyInstances {
    Box3f box;                         ///< of all of them, in the scene's normalized space
    std::vector<std::uint32_t> items;  ///< their numbers among the geometry's items, ascending
};

/// Finds such instances, at least 64 to a group, among `singles`, bounded primitives of any kind.
std::vector<TinyInstances> find_tiny_instances(const Geometry& geometry,
                                               const std::vector<BoundedPrimitive>& singles);

}  // namespace etalon
