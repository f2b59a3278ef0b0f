#pragma once

#include <optional>
#include <span>

#include "core/intersect/bounded.h"

namespace etalon {

struct PresplitConfig {
    double budget = 0.25;     ///< pieces that may be added, for each primitive
    double least_gain = 0.6;  ///< the share of all boxes' surface that must be saved to begin with
};

/// Primitives with some triangles cut into pieces.
struct Presplit {
    std::vector<BoundedPrimitive> references;  ///< each piece in a box of its own, as its triangle
    std::vector<BoundedPrimitive> cut;         ///< primitives that are in pieces, whole
};

/// Cuts the triangles whose boxes hold the most that is not triangle (Karras & Aila 2013, "Fast
/// Parallel Construction of High-Quality Bounding Volume Hierarchies", section 4.3). Nothing where
/// a sample of the triangles says that they would not gain by it.
std::optional<Presplit> presplit(const Geometry& geometry, const NormalizedSpace& space,
                                 std::span<const BoundedPrimitive> primitives,
                                 const PresplitConfig& config = {});

}  // namespace etalon
