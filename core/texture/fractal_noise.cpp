#include "core/texture/fractal_noise.h"

#include <cmath>

#include "core/texture/gradient_noise.h"

namespace etalon {
namespace {

/// Sums `part` of the noise of each octave, with the octave's weight.
template <class Part>
double sum_of_octaves(const FractalNoise& noise, const Vec3& p, Part part) {
    constexpr double last_frequency = 1e16;  // beyond, coordinates of about 1 have no digits
    double sum = 0, weight = 1, frequency = 1;
    for (int i = 0; i < noise.octaves && frequency < last_frequency; ++i) {
        sum += weight * part(gradient_noise(frequency * p));
        frequency *= lacunarity;
        weight *= noise.roughness;
    }
    return sum;
}

}  // namespace

double fractional_brownian_motion(const FractalNoise& noise, const Vec3& p) {
    return sum_of_octaves(noise, p, [](double x) { return x; });
}

double turbulence(const FractalNoise& noise, const Vec3& p) {
    return sum_of_octaves(noise, p, [](double x) { return std::abs(x); }) +
           0.2 * std::pow(double(noise.roughness), std::max(noise.octaves, 0));
}

}  // namespace etalon
