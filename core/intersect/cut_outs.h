// Holes in surfaces: rays pass where a texture says so.
#pragma once

#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Tells of the holes of surfaces that are cut out. The kernels ask it, and so every backend has
/// the same holes. Thread-safe.
class CutOuts {
  public:
    CutOuts() = default;
    virtual ~CutOuts() = default;
    CutOuts(const CutOuts&) = delete;
    CutOuts& operator=(const CutOuts&) = delete;

    /// Whether there is nothing at a point of a surface for a ray, which may be a shadow ray.
    /// `geometry` is that in which the point's primitive is, and its space the point's: an object's
    /// for instances.
    virtual bool is_hole(const Geometry& geometry, const SurfacePoint& point,
                         bool for_shadow) const = 0;
};

}  // namespace etalon
