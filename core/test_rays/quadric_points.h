// Points of a quadric, for aiming at it.
#pragma once

#include "core/numerics/random.h"
#include "core/scene/quadric_form.h"
#include "core/scene/shapes.h"

namespace etalon {

/// Random points of a quadric and its box. Those of the surface are searched on random lines; a
/// point of the clip box serves if none is found.
class QuadricPoints {
  public:
    explicit QuadricPoints(const Quadric& quadric);

    Vec3 in_clip(Random& random) const;
    Vec3 on_surface(Random& random) const;

    /// Returns a point where the surface meets a face of the clip box.
    Vec3 on_rim(Random& random) const;

    /// Returns a point in a direction from `from` in which the surface is seen edge-on, but for
    /// `off` times the box's size.
    Vec3 silhouette(const Vec3& from, double off, Random& random) const;

  private:
    Vec3 in_face(int axis, double face, Random& random) const;

    Vec3 centre_;
    QuadricForm<double> form_;
    Box3 clip_;
};

}  // namespace etalon
