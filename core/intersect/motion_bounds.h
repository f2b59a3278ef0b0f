// Where the instance of a motion goes while the shutter is open.
#pragma once

#include <array>
#include <span>

#include "core/scene/animated_transform.h"

namespace etalon {

/// Returns the box of the image of a box.
Box3 image(const Affine& map, const Box3& box);

/// The way of a moving object in slices: where it is at their ends, and bounds on what it does in
/// between.
class MotionBounds {
  public:
    explicit MotionBounds(const AnimatedTransform& motion);

    /// Returns whether there are bounds: false where the map is singular or nearly so, or not
    /// finite, at any time.
    bool exist() const { return spread_ < infinity; }

    /// Returns the box of all places of the points of `box`.
    Box3 box(const Box3& box) const;

    /// Bounds |A^-1| |A| v at all times, A the inverse of the map, v three components 1: for each
    /// axis.
    double spread() const { return spread_; }

    /// Returns how far from a point the object's origin gets, in the largest of three coordinates.
    double distance_from(const Vec3& point) const;

  private:
    static constexpr std::size_t slices = 32;

    const AnimatedTransform& motion_;
    double length_;  ///< of a slice, as a part of the motion
    std::array<Affine, slices + 1> maps_;
    double spread_ = infinity;
};

}  // namespace etalon
