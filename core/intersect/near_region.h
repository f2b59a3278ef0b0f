#pragma once

#include "core/numerics/vec.h"

namespace etalon {

struct Geometry;

/// Returns the box of all points.
inline Box3 everywhere() {
    return {Vec3(-infinity), Vec3(infinity)};
}

/// Returns whether the box is not empty and all of its coordinates are finite.
inline bool is_bounded(const Box3& box) {
    return !box.isEmpty() && is_finite(box.min) && is_finite(box.max);
}

/// A cube around most of a scene. Bounded items that are not inside of it are outliers: see
/// outliers.h.
struct NearRegion {
    /// Returns the largest difference of a coordinate of the box from that of the centre.
    double reach_of(const Box3& box) const {
        return std::max(max_abs(box.min - centre), max_abs(box.max - centre));
    }

    bool contains(const Box3& box) const { return is_bounded(box) && reach_of(box) <= reach; }

    bool is_everything() const { return reach == infinity; }

    Vec3 centre{0};
    double reach = infinity;  ///< half the edge
};

/// Returns the point whose coordinates are the medians of those of the items, of which it takes a
/// thousand. Some that are far away do not move it, which they would the centre of all boxes.
Vec3 middle_of(const Geometry& geometry);

}  // namespace etalon
