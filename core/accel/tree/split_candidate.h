// Which triangles are worth cutting, and into how many pieces (Karras & Aila 2013, "Fast Parallel
// Construction of High-Quality Bounding Volume Hierarchies", section 4.3).
#pragma once

#include <array>
#include <span>

#include "core/intersect/bounded.h"

namespace etalon {

/// A primitive as something to cut.
struct SplitCandidate {
    SplitCandidate(const Geometry& geometry, const NormalizedSpace& space,
                   const BoundedPrimitive& p);

    /// For a factor that is the same for all.
    int cuts(double factor) const;

    /// With boxes that shrink along two axes where a thin triangle is cut across the third.
    double surface_after(int cuts) const { return least + (surface - least) / (1 + cuts); }

    double surface;       ///< of its box, in normalized space
    double least;         ///< what the surfaces of ever smaller pieces' boxes come to
    double priority = 0;  ///< 0: not to be cut
};

/// False for those that a factor up to `limit` does not cut, by their boxes alone.
bool might_be_cut(const BoundedPrimitive& p, double limit);

std::array<Vec3, 3> corners_of(const Geometry& geometry, const BoundedPrimitive& triangle);

/// The largest factor up to `limit` that makes no more cuts than may be.
double best_factor(std::span<const SplitCandidate> candidates, double cuts, double limit);

/// The share of the boxes' surface that cutting saves.
double gain(std::span<const SplitCandidate> candidates, double factor);

}  // namespace etalon
