#pragma once

#include <optional>

#include "core/scene/scene.h"

namespace etalon {

/// The same shapes, moved; nothing where that leads beyond all numbers.
std::optional<Geometry> moved(Geometry geometry, const Vec3& offset);

/// The scene with every length times `factor` > 0, and then every point moved by `offset`: shapes,
/// lights and the camera, but not how glass absorbs light. Holes that have been made stay where
/// they were made.
Scene transformed(Scene scene, double factor, const Vec3& offset = Vec3(0));

}  // namespace etalon
