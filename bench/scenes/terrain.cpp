#include "bench/scenes/bench_families.h"
#include "bench/scenes/shared_corners.h"
#include "bench/scenes/stage.h"
#include "core/sampling/sobol.h"

namespace etalon::bench {
namespace {

/// Smoothstep: its first derivative vanishes at 0 and 1, so that cells of noise join smoothly.
double smooth(double x) {
    return x * x * (3 - 2 * x);
}

/// Value noise: interpolates random values in [-1, 1] at integer points.
double noise(double x, double y, std::uint32_t seed) {
    const double left = std::floor(x), low = std::floor(y);
    const auto value = [&](int dx, int dy) {
        const auto i = static_cast<std::uint32_t>(left + dx);
        const auto j = static_cast<std::uint32_t>(low + dy);
        return hash(hash(seed, i), j) * 0x1p-31 - 1;
    };
    const double u = smooth(x - left), v = smooth(y - low);
    return std::lerp(std::lerp(value(0, 0), value(1, 0), u), std::lerp(value(0, 1), value(1, 1), u),
                     v);
}

/// Sum of octaves of noise, each with half the amplitude and twice the frequency, down to two quads
/// (fractional Brownian motion: Mandelbrot & Van Ness 1968; for terrain, Fournier, Fussell &
/// Carpenter 1982).
double height(double x, double y, std::uint32_t quads) {
    double sum = 0, amplitude = 0.2;
    std::uint32_t octave = 0;
    for (double frequency = 3; frequency * 2 <= std::max(quads, 6U); frequency *= 2) {
        sum += amplitude * noise(frequency * x, frequency * y, octave++);
        amplitude /= 2;
    }
    return sum;
}

}  // namespace

Scene terrain(std::size_t count) {
    Scene scene = empty_scene({.eye = {1.0, 1.2, 1.2}, .at = {0, -0.1, 0}, .light = {-2, 2.5, 1}});
    const double edge = std::max(1.0, std::round(std::sqrt(static_cast<double>(count) / 2)));
    const auto quads = static_cast<std::uint32_t>(edge);
    add_sheet(scene, {quads, quads},
              [&](double x, double y) { return Vec3(2 * x - 1, height(x, y, quads), 1 - 2 * y); });
    return scene;
}

}  // namespace etalon::bench
