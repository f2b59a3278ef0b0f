#pragma once

#include <vector>

#include "core/scene/camera.h"

namespace etalon {

/// Returns the rectangles for LensSystem::exit_pupils of a focused lens, each with a margin as wide
/// as pbrt-v3's. If no light passes, a rectangle contains everything that can see the last surface.
std::vector<Imath::Box2d> exit_pupils(const std::vector<LensSurface>& surfaces,
                                      double film_diagonal);

}  // namespace etalon
