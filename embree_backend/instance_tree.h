#pragma once

#include <vector>

#include "core/accel/wide/wide_tree.h"
#include "core/intersect/instance_bounds.h"

namespace etalon {

/// A wide tree of instances that are tiny beside the scene and near each other. For Embree it is
/// one primitive. Its boxes are in a normalized space of its own, with least_padding, for
/// FineSlabs: Embree's float boxes need a padding of 2^-19 of the scene.
struct InstanceTree {
    /// `all` are the numbers of at least one instance among the geometry's items; `bounds` are with
    /// least_padding. `scene` is the space of the scene.
    InstanceTree(const Geometry& geometry, const NormalizedSpace& scene,
                 const InstanceBounds& bounds, std::vector<std::uint32_t> all);

    std::size_t memory_bytes() const {
        return wide.nodes.capacity() * sizeof(WideNode) + items.capacity() * sizeof(std::uint32_t);
    }

    std::vector<std::uint32_t> items;
    NormalizedSpace space;
    double spread;  ///< see InstanceBounds
    WideTree wide;  ///< each leaf is a single instance
};

}  // namespace etalon
