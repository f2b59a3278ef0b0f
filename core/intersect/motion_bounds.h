// Bounds of a moving instance while the shutter is open.
#pragma once

#include <array>
#include <span>

#include "core/intersect/object_outline.h"
#include "core/scene/animated_transform.h"

namespace etalon {

/// Returns a box around the image of a box under the map.
Box3 image(const Affine& map, const Box3& box);

/// Bounds of a moving object. The motion is cut into time slices; positions at their ends are
/// exact, and in between the departure from a straight line is bounded.
class MotionBounds {
  public:
    explicit MotionBounds(const AnimatedTransform& motion);

    /// Returns whether the bounds exist. False where the map is singular or nearly so, or not
    /// finite, at any time.
    bool exist() const { return spread_ < infinity; }

    /// Returns the box of all positions of the points of `box`.
    Box3 box(const Box3& box) const;

    /// The same for the points of an object.
    Box3 box(const ObjectOutline& outline) const;

    /// Returns a bound on |A^-1| |A| v at all times, for each axis: A is the inverse of the map,
    /// and v has three components 1.
    double spread() const { return spread_; }

    /// Returns the largest distance of the object's origin from a point, as the largest of the
    /// three coordinates.
    double distance_from(const Vec3& point) const;

  private:
    static constexpr std::size_t slices = 32;

    /// Returns the box of all positions of the points of `box`, or of some of them: image(map) is a
    /// box of what they are at one time.
    template <class Image>
    Box3 box_of_images(const Box3& box, const Image& image) const;

    const AnimatedTransform& motion_;
    double length_;  ///< of a slice, as a fraction of the motion
    std::array<Affine, slices + 1> maps_;
    double spread_ = infinity;
};

}  // namespace etalon
