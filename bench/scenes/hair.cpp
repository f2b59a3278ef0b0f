#include "bench/scenes/bench_families.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {
namespace {

/// A hair on a ball, which falls to one side and tapers.
BezierCurve hair_at(const Vec3& root, const Vec3& bend, double width) {
    BezierCurve c{};
    const Vec3 steps[] = {0.12 * root, 0.12 * root + 0.06 * bend, 0.08 * root + 0.2 * bend};
    Vec3 p = 0.5 * root;
    c.points[0] = Vec3f(p);
    for (std::size_t i = 0; i < 3; ++i) c.points[i + 1] = Vec3f(p += steps[i]);
    c.widths = {static_cast<float>(width), static_cast<float>(0.3 * width)};
    c.type = CurveType::cylinder;
    return c;
}

}  // namespace

/// More hairs are thinner, so that the ball is covered equally densely.
Scene hair(std::size_t count) {
    constexpr std::uint32_t parts = 8;  // pbrt-v3's
    Scene scene = empty_scene();
    Random random(12);
    const double width = 1 / std::sqrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 root = random.direction();
        const Vec3 bend = Vec3(0.3, -1, 0.2) + 0.5 * random.in_cube();
        const BezierCurve curve = hair_at(root, bend, width);
        for (std::uint32_t part = 0; part < parts; ++part) {
            scene.geometry.add(Curve(curve, Affine{}, {part, parts}), 0);
        }
    }
    return scene;
}

}  // namespace etalon::bench
