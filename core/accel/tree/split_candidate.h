// Selection of triangles to cut, and into how many pieces (Karras & Aila 2013, "Fast Parallel
// Construction of High-Quality Bounding Volume Hierarchies", section 4.3).
#pragma once

#include <array>
#include <span>

#include "core/intersect/bounded.h"

namespace etalon {

/// A primitive that may be cut.
struct SplitCandidate {
    SplitCandidate(const Geometry& geometry, const NormalizedSpace& space,
                   const BoundedPrimitive& p);

    /// Returns the number of cuts for a factor, which is the same for all candidates.
    int cuts(double factor) const;

    /// Returns the surface area after cutting a thin triangle across one axis: its boxes shrink
    /// along the other two.
    double surface_after(int cuts) const { return least + (surface - least) / (1 + cuts); }

    double surface;       ///< surface area of its box, in normalized space
    double least;         ///< limit of the surface area for ever smaller pieces
    double priority = 0;  ///< 0 if it is not to be cut
};

/// Returns whether a factor up to `limit` might cut a primitive, judged by its box alone.
bool might_be_cut(const BoundedPrimitive& p, double limit);

std::array<Vec3, 3> corners_of(const Geometry& geometry, const BoundedPrimitive& triangle);

/// Returns the largest factor up to `limit` that makes at most `cuts` cuts.
double best_factor(std::span<const SplitCandidate> candidates, double cuts, double limit);

/// Returns the share of the boxes' surface area that cutting saves.
double gain(std::span<const SplitCandidate> candidates, double factor);

}  // namespace etalon
