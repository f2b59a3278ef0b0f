#pragma once

#include <span>
#include <vector>

#include "core/scene/geometry.h"

namespace etalon {

/// An object as the boxes of what lies in the octants about its centre. Transformed to world space
/// they are smaller than the box of a single one.
class ObjectOutline {
  public:
    struct Part {
        Vec3 centre, half;
    };

    ObjectOutline() = default;
    explicit ObjectOutline(const Geometry& object);

    bool is_unbounded() const { return is_unbounded_; }

    /// Empty for an object that is empty or unbounded.
    std::span<const Part> parts() const { return parts_; }

    /// Returns the box of the images of all parts.
    Box3 image(const Affine& map) const;

  private:
    std::vector<Part> parts_;
    bool is_unbounded_ = false;
};

}  // namespace etalon
