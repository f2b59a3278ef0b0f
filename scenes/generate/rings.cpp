#include <array>

#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"

namespace etalon::generate {
namespace {

constexpr double bar = 0.07;  ///< radius of a ring's bars; under 0.074 the rings do not touch

/// A pentagon of bars about `axis`, with a corner towards `corner`; both unit vectors.
void ring(Writer& out, const Vec3& centre, double radius, const Vec3& axis, const Vec3& corner) {
    const Vec3 across = axis % corner;
    std::array<Vec3, 6> corners;
    for (int k = 0; k < 6; ++k) {
        const Vec2 c = on_circle(k / 5.0);
        corners[k] = centre + radius * (c.x * corner + c.y * across);
    }
    for (int k = 0; k < 5; ++k) {
        out.cone(corners[k], radius * bar, corners[k + 1], radius * bar);
        out.sphere(corners[k], radius * bar);
    }
}

/// Six rings, one across each fivefold axis of the icosahedron. Where two of their planes meet,
/// one ring has a corner at +x and the middle of a side at -x, the other the reverse: so each two
/// are linked (Holden 1983, "Orderly Tangles").
void knot(Writer& out, const Vec3& centre, double radius) {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    const double length = std::sqrt(1 + golden * golden);
    for (int cycle = 0; cycle < 3; ++cycle) {
        for (const double sign : {1.0, -1.0}) {
            Vec3 axis;
            Vec3 corner;
            axis[(cycle + 1) % 3] = sign / length;
            axis[(cycle + 2) % 3] = golden / length;
            corner[cycle] = sign;
            axis[cycle] = corner[(cycle + 1) % 3] = corner[(cycle + 2) % 3] = 0;
            ring(out, centre, radius, axis, corner);
        }
    }
}

}  // namespace

void rings(Writer& out, std::int64_t size) {
    out.background({0.08F, 0.36F, 0.75F});
    out.camera({{1.9, 2.3, 3.9}, {0, 0.6, 0}, {0, 1, 0}, 36}, {512, 512});
    out.light({5, 8, 2}, {0.55F, 0.52F, 0.46F});
    out.light({-6, 7, 5}, {0.35F, 0.37F, 0.42F});
    out.light({1, 6, 9}, {0.2F, 0.2F, 0.2F});
    ground(out);
    out.material({.diffuse = {1.0F, 0.72F, 0.35F},
                  .kd = 0.75,
                  .specular = {1.0F, 0.8F, 0.5F},
                  .ks = 0.25,
                  .shine = 50});

    // Piled like cannon balls, on a base two units wide.
    const double reach = 1.0 / static_cast<double>(size);
    const double layer_height = reach * std::sqrt(2.0);
    for (std::int64_t layer = 1; layer <= size; ++layer) {
        const double y = reach + static_cast<double>(size - layer) * layer_height;
        for (std::int64_t i = 0; i < layer * layer; ++i) {
            const auto x = static_cast<double>(2 * (i % layer) - layer + 1);
            const auto z = static_cast<double>(2 * (i / layer) - layer + 1);
            knot(out, {reach * x, y, reach * z}, reach / (1 + bar));
        }
    }
}

}  // namespace etalon::generate
