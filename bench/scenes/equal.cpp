#include <utility>

#include "bench/scenes/bench_families.h"
#include "bench/scenes/shared_corners.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {
namespace {

/// Returns a triangle whose vertices are at 0, -a and a along every axis, in an order rotated from
/// axis to axis: so the centroid and the centre of the bounds are both exactly zero, and the
/// vertices are never collinear.
std::array<Vec3, 3> centred_corners(Random& random) {
    const std::size_t first = random.index(3);
    std::array<Vec3, 3> corners{Vec3(0), Vec3(0), Vec3(0)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = random.sign() * random.magnitude(-3, 0);
        const auto k = static_cast<int>((first + axis) % 3);
        corners[(axis + 1) % 3][k] = a;
        corners[(axis + 2) % 3][k] = -a;
    }
    return corners;
}

}  // namespace

/// All triangles have the same centre, so a builder that splits by centres sees one point.
Scene equal(std::size_t count) {
    Scene scene = empty_scene({.fov_degrees = 20});
    Random random(4);
    for (std::size_t i = 0; i < count; ++i) {
        const auto [a, b, c] = centred_corners(random);
        add_triangle(scene, a, b, c);
    }
    return scene;
}

}  // namespace etalon::bench
