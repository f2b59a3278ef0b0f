// Definition of each shape, evaluated in quad precision with error bounds. They are deliberately
// not the kernels' formulas, which are checked against this.
#pragma once

#include <array>

#include "core/intersect/ray.h"
#include "core/oracle/tracked.h"
#include "core/scene/geometry.h"

namespace etalon {

/// A point where the ray's line crosses a surface.
struct Crossing {
    Crossing() = default;
    Crossing(const Tracked& at, Certainty is_there, Certainty is_front)
        : t(at), passage(at), exists(is_there), front(is_front) {}

    Tracked t;  ///< value that a kernel should return
    /// Value that must also be beyond tmin: t, except for polygons with corners off their plane;
    /// there that of the plane.
    Tracked passage;
    Certainty exists;
    Certainty front;  ///< whether the front is seen there
};

/// Crossings of a line with a shape: at most two, in no particular order.
class Crossings {
  public:
    void add(const Crossing& c) { list_[count_++] = c; }
    const Crossing* begin() const { return list_.data(); }
    const Crossing* end() const { return list_.data() + count_; }

  private:
    std::array<Crossing, 2> list_;
    std::size_t count_ = 0;
};

/// Returns the crossings of the line of `ray`, whose direction is not zero, with a primitive. As in
/// RayQuery, a component that is negligible against the largest is zero.
Crossings crossings(const Geometry& geometry, std::uint32_t primitive, const Ray& ray);

}  // namespace etalon
