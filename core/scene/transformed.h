#pragma once

#include "core/scene/scene.h"

namespace etalon {

/// The scene with every length times `factor` > 0, and then every point moved by `offset`: shapes,
/// lights and the camera, but not how matter absorbs light.
Scene transformed(Scene scene, double factor, const Vec3& offset = Vec3(0));

/// Moves the shapes of the primitives and the vertices from these numbers on by `offset`. Returns
/// whether all of them are still at finite places.
bool move_since(Scene& scene, std::size_t first_primitive, std::size_t first_vertex,
                const Vec3& offset);

}  // namespace etalon
