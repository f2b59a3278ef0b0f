#include <array>

#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"

namespace etalon::generate {
namespace {

using Tetrahedron = std::array<Vec3, 4>;  ///< seen from the last corner, the others run clockwise

void four_triangles(Writer& out, const Tetrahedron& t) {
    constexpr int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    for (const auto& f : faces) out.polygon(std::array{t[f[0]], t[f[1]], t[f[2]]});
}

/// Divides the tetrahedron in two towards each of its corners, `depth` times over.
void divide(Writer& out, const Tetrahedron& t, std::int64_t depth) {
    if (depth == 0) return four_triangles(out, t);
    for (const Vec3& corner : t) {
        Tetrahedron half;
        for (int k = 0; k < 4; ++k) half[k] = (t[k] + corner) / 2;
        divide(out, half, depth - 1);
    }
}

/// Returns a regular tetrahedron of circumradius 1 on the ground.
Tetrahedron whole() {
    Tetrahedron t;
    for (int k = 0; k < 3; ++k) {
        const Vec2 c = on_circle(k / 3.0);
        t[k] = {c.x, 0, c.y};
    }
    t[3] = {0, std::sqrt(2.0), 0};
    return t;
}

}  // namespace

void tetra(Writer& out, std::int64_t size) {
    out.background({0.08F, 0.36F, 0.75F});
    out.camera({{1.1, 1.5, 3.4}, {0.1, 0.55, 0}, {0, 1, 0}, 32}, {512, 512});
    out.light({4, 6, 3}, {0.8F, 0.76F, 0.7F});
    out.light({-5, 4, 5}, {0.3F, 0.34F, 0.4F});
    ground(out);
    out.material({.diffuse = {1.0F, 0.25F, 0.2F}});
    divide(out, whole(), size);
}

}  // namespace etalon::generate
