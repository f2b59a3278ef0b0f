#pragma once

#include <optional>
#include <span>

#include "core/intersect/bounded.h"

namespace etalon {

struct PresplitConfig {
    double budget = 0.25;     ///< largest number of additional pieces, for each primitive
    double least_gain = 0.6;  ///< least share of the boxes' surface area that cutting must save
};

/// The primitives of a scene after some triangles were cut into pieces.
struct Presplit {
    std::vector<BoundedPrimitive> references;  ///< one for each piece, with the triangle's number
    std::vector<BoundedPrimitive> cut;         ///< the primitives that were cut, whole
};

/// Cuts the triangles whose boxes are emptiest (Karras & Aila 2013, "Fast Parallel Construction of
/// High-Quality Bounding Volume Hierarchies", section 4.3). Returns nothing if a sample of the
/// triangles shows that cutting would not pay.
std::optional<Presplit> presplit(const Geometry& geometry, const NormalizedSpace& space,
                                 std::span<const BoundedPrimitive> primitives,
                                 const PresplitConfig& config = {});

}  // namespace etalon
