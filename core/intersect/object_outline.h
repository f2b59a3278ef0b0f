#pragma once

#include "core/intersect/directional_extents.h"
#include "core/scene/geometry.h"

namespace etalon {

/// An object as its extents along many directions, which bound its images under affine maps.
class ObjectOutline {
  public:
    ObjectOutline() = default;
    explicit ObjectOutline(const Geometry& object);

    /// Returns the object's box: empty if nothing of it can be hit, everywhere() if it is
    /// unbounded.
    const Box3& box() const { return box_; }

    /// Returns a box of the image under a finite map; everywhere() also where products leave the
    /// range of double. For most objects it is little larger than the smallest.
    Box3 image(const Affine& map) const;

  private:
    Box3 box_;
    DirectionalExtents extents_;  ///< from the centre of the box
};

}  // namespace etalon
