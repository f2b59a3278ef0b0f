#include <array>

#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"

namespace etalon::generate {
namespace {

/// Returns the directions of the nine small spheres on one whose pole is z: six round the equator
/// and three midway up, above the gaps between every other pair.
std::array<Vec3, 9> nine_directions() {
    std::array<Vec3, 9> directions;
    for (int k = 0; k < 6; ++k) {
        const Vec2 c = on_circle(k / 6.0);
        directions[k] = {c.x, c.y, 0};
    }
    const double height = std::sqrt(2.0 / 3.0);
    const double radius = std::sqrt(1.0 / 3.0);
    for (int k = 0; k < 3; ++k) {
        const Vec2 c = on_circle(k / 3.0 + 1 / 12.0);
        directions[6 + k] = {radius * c.x, radius * c.y, height};
    }
    return directions;
}

/// A sphere and what it bears. `pole` is a unit vector, `side` one across it.
void flake(Writer& out, const Vec3& centre, double radius, const Vec3& pole, const Vec3& side,
           std::int64_t depth) {
    out.sphere(centre, radius);
    if (depth == 0) return;
    static const std::array<Vec3, 9> directions = nine_directions();
    const Vec3 across = pole % side;
    for (const Vec3& d : directions) {
        const Vec3 outward = d.x * side + d.y * across + d.z * pole;
        flake(out, centre + radius * 4 / 3 * outward, radius / 3, outward,
              (pole % outward).normalized(), depth - 1);
    }
}

}  // namespace

void sphereflake(Writer& out, std::int64_t size) {
    out.background({0.08F, 0.36F, 0.75F});
    out.camera({{3.6, 3.4, 4.6}, {0, 1.1, 0}, {0, 1, 0}, 37}, {512, 512});
    out.light({6, 8, 3}, {0.6F, 0.57F, 0.5F});
    out.light({-5, 6, 6}, {0.4F, 0.42F, 0.45F});
    out.light({2, 9, -6}, {0.3F, 0.3F, 0.35F});
    ground(out);
    out.material({.diffuse = {1.0F, 0.85F, 0.6F}, .kd = 0.7, .ks = 0.3, .shine = 40});
    flake(out, {0, 1, 0}, 1, {0, 1, 0}, {1, 0, 0}, size);
}

}  // namespace etalon::generate
