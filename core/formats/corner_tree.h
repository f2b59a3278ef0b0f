#pragma once

#include <cstdint>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

using Box2 = Imath::Box2d;

/// A triangle in the plane, counter-clockwise, with its boundary.
struct PlaneTriangle {
    Vec2 a, b, c;

    /// Returns whether a point of the box lies in the triangle. Exact.
    bool meets(const Box2& box) const;
    bool has_corner(const Vec2& p) const { return p == a || p == b || p == c; }
};

/// Finds those of a set of corners that lie in a triangle: a complete k-d tree of bounding boxes
/// over all corners of an outline, each of which is in the set or not.
class CornerTree {
  public:
    explicit CornerTree(const std::vector<Vec2>& outline);

    /// Adds a corner to the set, which is empty at first, or removes it.
    void set(std::uint32_t corner, bool member);

    /// Returns whether a member lies in the triangle, other than at one of its corners.
    bool any_in(const PlaneTriangle& triangle) const { return any_in(triangle, 1); }

  private:
    void sort(std::uint32_t* first, std::uint32_t* last, std::size_t room, int axis);
    bool any_in(const PlaneTriangle& triangle, std::size_t node) const;

    const std::vector<Vec2>& outline_;
    std::size_t leaves_;             ///< a power of two; the children of node i are 2i and 2i + 1
    std::vector<std::size_t> node_;  ///< the leaf of a corner
    std::vector<Box2> boxes_;        ///< of the members below a node
};

}  // namespace etalon
