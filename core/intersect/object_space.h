#pragma once

#include <array>

#include "core/intersect/bounded.h"

namespace etalon {

/// Normalized space of an object in the form in which rays enter it, with the three axes side by
/// side for vector loads. An unbounded object has infinite reach.
struct alignas(32) ObjectSpace {
    using Axes = std::array<double, 4>;

    explicit ObjectSpace(const SceneBounds& object)
        : ObjectSpace(object.space, object.has_more() ? Vec3(infinity) : object.space.reach()) {}

    /// Returns whether it is bounded and of a size for which t is resolved for every ray with a
    /// direction of usual length.
    bool is_usual() const {
        return reach[0] < infinity && scale > 1 / largest_scale && scale < largest_scale;
    }

    Axes centre, reach;
    Axes next_reach;  ///< of the axis after each
    Axes outside;     ///< beyond reach and roundings
    double scale;
    double furthest;  ///< from the centre, of the origins of rays that are resolved

  private:
    static constexpr double largest_scale = 0x1p700;

    ObjectSpace(const NormalizedSpace& space, const Vec3& r)
        : centre(axes(space.centre())),
          reach(axes(r)),
          next_reach(axes({r.y, r.z, r.x})),
          outside(axes((1 + 0x1p-40) * r)),
          scale(space.scale()),
          furthest(NormalizedSpace::largest_distance / scale) {}

    static Axes axes(const Vec3& v) { return {v.x, v.y, v.z, 0}; }
};

}  // namespace etalon
