#include "bench/scenes/bench_families.h"
#include "bench/scenes/needles.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {
namespace {

constexpr double share_of_needles = 18.0 / 268;
constexpr double nearest = 4, farthest = 20;  ///< distances of needles from the torus's centre

/// Adds needles that are parallel to no axis; the centre of each is its closest point to the
/// torus's centre.
void add_needles(Scene& scene, std::size_t count) {
    Random random(6);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 outward = random.direction();
        const double distance = random.uniform(nearest, farthest);
        const Vec3 direction = across(outward, random.uniform(0, turn));
        const double length = random.uniform(7, 10), width = random.uniform(0.001, 0.021);
        add_needle(scene, distance * outward, direction, length, width, random);
    }
}

/// The torus, 0.2 wide, tilted towards the camera.
void add_torus(Scene& scene, double triangles) {
    const double around = std::max(3.0, std::round(std::sqrt(triangles / 4)));
    const double along = std::max(3.0, std::round(triangles / (2 * around)));
    const Sheet sheet{static_cast<std::uint32_t>(along), static_cast<std::uint32_t>(around), true};
    Vec3 u, v;
    const Vec3 axis = Vec3(1, 2, 3).normalized();
    orthonormal_basis(axis, u, v);
    add_sheet(scene, sheet, [&](double x, double y) {
        const Vec3 radial = std::cos(turn * x) * u + std::sin(turn * x) * v;
        return (0.07 + 0.03 * std::cos(turn * y)) * radial + 0.03 * std::sin(turn * y) * axis;
    });
}

}  // namespace

/// A teapot in a stadium whose seats no box fits: the detailed object is small, and every needle's
/// box contains most of the scene. The camera looks at the torus from among the needles.
Scene stadium(std::size_t count) {
    Scene scene = empty_scene({.eye = {0.2, 0.15, 0.4}, .fov_degrees = 30, .light = {1, 1.5, 1.2}});
    const double needles = std::round(share_of_needles * static_cast<double>(count));
    add_needles(scene, static_cast<std::size_t>(needles));
    add_torus(scene, static_cast<double>(count) - needles);
    return scene;
}

}  // namespace etalon::bench
