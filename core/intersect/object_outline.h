#pragma once

#include "core/intersect/directional_extents.h"
#include "core/scene/geometry.h"

namespace etalon {

/// An object as its extents along many directions. Its image under a map has little more than the
/// smallest box.
class ObjectOutline {
  public:
    ObjectOutline() = default;
    explicit ObjectOutline(const Geometry& object);

    /// Returns whether it has bounds that can be calculated with. That of an empty object is
    /// bounded, too.
    bool is_unbounded() const { return is_unbounded_; }

    /// Returns the object's box. Empty for an object that is empty or unbounded.
    const Box3& box() const { return box_; }

    /// Returns a box of the image.
    Box3 image(const Affine& map) const;

  private:
    Box3 box_;
    DirectionalExtents extents_;  ///< from the centre of the box
    bool is_unbounded_ = false;
};

}  // namespace etalon
