#include <utility>

#include "bench/scenes/bench_families.h"
#include "bench/scenes/shared_corners.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {
namespace {

/// Along every axis the corners are at 0, -a and a, each time in an order that starts elsewhere:
/// so the mean of the corners and the middle of the box are both zero, without rounding, and the
/// corners are never on a line.
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

/// A builder that splits by centres sees one point.
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
