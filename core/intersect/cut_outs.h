// Holes in surfaces, through which rays pass: the points where an alpha texture is 0.
#pragma once

#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Tells where cut-out surfaces have holes. The kernels call it, so every backend sees the same
/// holes. Thread-safe.
class CutOuts {
  public:
    CutOuts() = default;
    virtual ~CutOuts() = default;
    CutOuts(const CutOuts&) = delete;
    CutOuts& operator=(const CutOuts&) = delete;

    /// Returns whether a point of a surface is in a hole for a ray, which may be a shadow ray.
    /// `geometry` holds the point's primitive, and the point is in its space: for an instance, in
    /// the space of its object.
    virtual bool is_hole(const Geometry& geometry, const SurfacePoint& point,
                         bool for_shadow) const = 0;
};

}  // namespace etalon
