#pragma once

#include "core/numerics/random.h"
#include "core/scene/scene.h"

namespace etalon {

/// A closed surface around `centre`, and what to aim at.
struct ClosedMesh {
    std::string name;
    Scene scene;
    Vec3 centre, radius;  ///< an ellipsoid's
    std::vector<std::vector<Vec3>> faces;
};

enum class Faces { triangles, mixed };  ///< mixed: quads and triangles by turns

/// A latitude-longitude sphere, stretched to an ellipsoid; corners rounded to float. Its poles are
/// shared by 2 x `rings` triangles each.
ClosedMesh uv_sphere(const std::string& name, const Vec3& centre, const Vec3& radius, Faces faces,
                     int rings = 100);

}  // namespace etalon
