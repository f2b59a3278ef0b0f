// Random primitives in a cube, with nothing else in the scene: work for an accelerator. Their
// extent shrinks with the cube root of their number, so that any size is about equally crowded.
#include <array>

#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"

namespace etalon::generate {
namespace {

/// Camera, lights and material for a cube [-1, 1]^3.
void stage(Writer& out) {
    out.background({0.08F, 0.1F, 0.14F});
    out.camera({{2.4, 2, 3.8}, {0, 0, 0}, {0, 1, 0}, 40}, {512, 512});
    out.light({4, 6, 5}, {0.8F, 0.75F, 0.68F});
    out.light({-5, 2, 4}, {0.25F, 0.28F, 0.34F});
    out.material({.diffuse = {0.9F, 0.8F, 0.65F}, .kd = 0.9});
}

/// The mean distance between `count` points of the cube.
double spacing(std::int64_t count) {
    return 2 / cube_root(static_cast<double>(count));
}

}  // namespace

void soup(Writer& out, std::int64_t size) {
    stage(out);
    const double reach = 0.5 * spacing(size);
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(size); ++i) {
        const Vec3 centre = noise_point(i, 0);
        out.polygon(std::array{centre + reach * noise_point(i, 1),
                               centre + reach * noise_point(i, 2),
                               centre + reach * noise_point(i, 3)});
    }
}

void spheres(Writer& out, std::int64_t size) {
    stage(out);
    const double unit = spacing(size);
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(size); ++i) {
        out.sphere(noise_point(i, 0), unit * (0.25 + 0.15 * noise(i, 3)));
    }
}

}  // namespace etalon::generate
