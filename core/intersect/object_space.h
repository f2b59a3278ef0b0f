#pragma once

#include <array>

#include "core/intersect/bounded.h"

namespace etalon {

/// What a ray into an object needs to know of the object's normalized space, with the numbers of
/// the three axes side by side, as vector instructions load them. An object that is not bounded
/// reaches everywhere.
struct alignas(32) ObjectSpace {
    using Axes = std::array<double, 4>;

    explicit ObjectSpace(const SceneBounds& object)
        : ObjectSpace(object.space,
                      object.unbounded.empty() ? object.space.reach() : Vec3(infinity)) {}

    /// Whether it is bounded, and every ray with a direction of usual length passes it in a t that
    /// is resolved.
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
