// Fournier, Fussell & Carpenter 1982, "Computer Rendering of Stochastic Models": each triangle is
// cut into four at its edges' midpoints, which are moved up or down at random, by less each time.
// The random number is a function of the midpoint's place alone, so the two triangles at an edge
// agree on it without knowing of each other, no height field is stored, and a larger size refines
// the same mountain.
#include <array>

#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"

namespace etalon::generate {
namespace {

/// A point of the height field: its place on a lattice fine enough for every size, and its height.
struct Point {
    std::int64_t x, z;
    double height;
};

constexpr std::int64_t lattice = std::int64_t{1} << 30;  ///< of x and z, for one unit of length
constexpr double roughness = 0.5;  ///< of each subdivision's movement to the one's before
constexpr double shore = -0.12;    ///< height of the four corners: under water
constexpr std::uint64_t seed = 8;

Vec3 position(const Point& p) {
    return {static_cast<double>(p.x) / lattice, p.height, static_cast<double>(p.z) / lattice};
}

Point midpoint(const Point& a, const Point& b, double movement) {
    const std::int64_t x = (a.x + b.x) / 2;
    const std::int64_t z = (a.z + b.z) / 2;
    const double random = noise(seed, static_cast<std::uint64_t>(x * 4 * lattice + z));
    return {x, z, (a.height + b.height) / 2 + movement * random};
}

void divide(Writer& out, const Point& a, const Point& b, const Point& c, double movement,
            std::int64_t depth) {
    if (depth == 0) return out.polygon(std::array{position(a), position(b), position(c)});
    const Point ab = midpoint(a, b, movement);
    const Point bc = midpoint(b, c, movement);
    const Point ca = midpoint(c, a, movement);
    movement *= roughness;
    divide(out, a, ab, ca, movement, depth - 1);
    divide(out, ab, b, bc, movement, depth - 1);
    divide(out, ca, bc, c, movement, depth - 1);
    divide(out, ab, bc, ca, movement, depth - 1);
}

void four_glass_spheres(Writer& out) {
    out.material({.diffuse = {0.8F, 0.95F, 1.0F},
                  .kd = 0,
                  .ks = 0.1,
                  .shine = 100,
                  .transmission = 1,
                  .ior = 1.5});
    const Vec3 middle(0.1, 0.8, 0.1);
    constexpr double radius = 0.15;
    for (int k = 0; k < 3; ++k) {
        const Vec2 c = on_circle(k / 3.0 + 0.05);
        out.sphere(middle + 1.25 * radius * Vec3(c.x, 0, c.y), radius);
    }
    out.sphere(middle + Vec3(0, 1.75 * radius, 0), radius);
}

}  // namespace

void mountain(Writer& out, std::int64_t size) {
    out.background({0.62F, 0.75F, 0.9F});
    out.camera({{1.1, 1.05, 2.7}, {0, 0.4, 0}, {0, 1, 0}, 40}, {512, 512});
    out.light({-8, 7, 4}, {0.8F, 0.73F, 0.62F});
    out.light({6, 6, 9}, {0.3F, 0.34F, 0.42F});
    ground(out, {.diffuse = {0.1F, 0.22F, 0.3F}, .ks = 0.4, .shine = 200});  // a lake
    four_glass_spheres(out);
    out.material({.diffuse = {0.62F, 0.52F, 0.42F}});
    const Point a{-lattice, -lattice, shore};
    const Point b{-lattice, lattice, shore};
    const Point c{lattice, lattice, shore};
    const Point d{lattice, -lattice, shore};
    divide(out, a, b, c, 0.7, size);
    divide(out, c, d, a, 0.7, size);
}

}  // namespace etalon::generate
