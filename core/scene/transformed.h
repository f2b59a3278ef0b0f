#pragma once

#include <optional>

#include "core/scene/scene.h"

namespace etalon {

/// Returns the same shapes, moved; nothing if a coordinate overflows.
std::optional<Geometry> moved(Geometry geometry, const Vec3& offset);

/// Returns the scene with every length multiplied by `factor` > 0, and then every point moved by
/// `offset`: shapes, lights and the camera, but not how glass absorbs light. Cut-outs that have
/// been made already are not transformed.
Scene transformed(Scene scene, double factor, const Vec3& offset = Vec3(0));

}  // namespace etalon
