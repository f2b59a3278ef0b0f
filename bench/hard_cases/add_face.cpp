#include "bench/hard_cases/add_face.h"

namespace etalon::hard {

void add_face(Scene& scene, const std::vector<Vec3>& corners, Sides sides) {
    if (corners.size() > 3) return scene.geometry.add(Polygon{corners}, 0, sides);
    const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
    scene.geometry.vertices.insert(scene.geometry.vertices.end(), corners.begin(), corners.end());
    scene.geometry.add(Triangle{{first, first + 1, first + 2}}, 0, sides);
}

}  // namespace etalon::hard
