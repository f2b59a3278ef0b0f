// Selection of triangles to cut, and into how many pieces (Karras & Aila 2013, "Fast Parallel
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

    /// Number of cuts for a factor that is the same for all candidates.
    int cuts(double factor) const;

    /// Surface after cutting a thin triangle across one axis: boxes shrink along the other two.
    double surface_after(int cuts) const { return least + (surface - least) / (1 + cuts); }

    double surface;       ///< surface of its box, in normalized space
    double least;         ///< limit of the surface of ever smaller pieces' boxes
    double priority = 0;  ///< 0: not to be cut
};

/// Returns whether a factor up to `limit` might cut a primitive, judged by its box alone.
bool might_be_cut(const BoundedPrimitive& p, double limit);

std::array<Vec3, 3> corners_of(const Geometry& geometry, const BoundedPrimitive& triangle);

/// The largest factor up to `limit` that makes no more cuts than may be.
double best_factor(std::span<const SplitCandidate> candidates, double cuts, double limit);

/// The share of the boxes' surface that cutting saves.
double gain(std::span<const SplitCandidate> candidates, double factor);

}  // namespace etalon
