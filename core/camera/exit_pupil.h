#pragma once

#include <vector>

#include "core/scene/camera.h"

namespace etalon {

/// Rectangles for LensSystem::exit_pupils: those of a focused lens, each with a margin as wide as
/// pbrt-v3's. Where no light comes through, all that could see the last surface.
std::vector<Imath::Box2d> exit_pupils(const std::vector<LensSurface>& surfaces,
                                      double film_diagonal);

}  // namespace etalon
