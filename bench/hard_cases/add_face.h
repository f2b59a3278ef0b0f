#pragma once

#include "core/scene/scene.h"

namespace etalon::hard {

/// Adds a triangle, or a polygon if there are more than three corners.
void add_face(Scene& scene, const std::vector<Vec3>& corners, Sides sides = Sides::both);

}  // namespace etalon::hard
