// Which triangles are worth cutting, and into how many pieces (Karras & Aila 2013, "Fast Parallel
// Construction of High-Quality Bounding Volume Hierarchies", section 4.3).
#pragma once

#include <span>

#include "core/intersect/bounded.h"
#include "core/intersect/tree/triangle_pieces.h"

namespace etalon {

/// A primitive as something to cut.
struct Prospect {
    Prospect() = default;
    Prospect(const Scene& scene, const Frame& frame, const BoundedPrimitive& p);

    /// For a factor that is the same for all.
    int cuts(double factor) const;

    /// With boxes that shrink along two axes where a thin triangle is cut across the third.
    double surface_after(int cuts) const { return least + (surface - least) / (1 + cuts); }

    double surface = 0;   ///< of its box, in the frame
    double least = 0;     ///< what the surfaces of ever smaller pieces' boxes come to
    double priority = 0;  ///< 0: not to be cut
};

Corners corners_of(const Scene& scene, const BoundedPrimitive& triangle);
Box3 box_of(const Corners& corners);

/// The largest factor up to `limit` that makes no more cuts than may be.
double best_factor(std::span<const Prospect> prospects, double cuts, double limit);

/// The share of the boxes' surface that cutting saves.
double gain(std::span<const Prospect> prospects, double factor);

}  // namespace etalon
