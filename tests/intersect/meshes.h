#pragma once

#include "core/numerics/random.h"
#include "core/scene/scene.h"

namespace etalon {

/// A closed surface around `centre`, and its faces to aim at.
struct ClosedMesh {
    std::string name;
    Scene scene;
    Vec3 centre, radius;  ///< an ellipsoid's
    std::vector<std::vector<Vec3>> faces;
};

enum class Faces { triangles, mixed };  ///< mixed: alternating quads and triangles

/// Returns a latitude-longitude sphere, stretched to an ellipsoid, with corners rounded to float.
/// Each pole is shared by 2 x `rings` triangles.
ClosedMesh uv_sphere(const std::string& name, const Vec3& centre, const Vec3& radius, Faces faces,
                     int rings = 100);

}  // namespace etalon
