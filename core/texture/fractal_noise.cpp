#include "core/texture/fractal_noise.h"

#include <array>
#include <cmath>
#include <span>

#include "core/texture/gradient_noise.h"

namespace etalon {
namespace {

/// Noise of the octaves at a point, lowest frequency first.
class Octaves {
  public:
    Octaves(int octaves, const Vec3& p) {
        Vec3Columns<room> points;
        double frequency = 1;
        for (; count_ < most && static_cast<int>(count_) < octaves; ++count_) {
            points.set(count_, frequency * p);
            frequency *= lacunarity;
        }
        for (std::size_t i = count_; i % padded_doubles != 0; ++i) points.set(i, Vec3(0));
        gradient_noise(points.span(), count_, values_.data());
    }

    std::span<const double> values() const { return std::span(values_).first(count_); }

  private:
    /// Beyond 1.99^53 = 7e15 coordinates of about 1 have no digits.
    static constexpr std::size_t most = 54;
    static constexpr std::size_t room =
        (most + padded_doubles - 1) / padded_doubles * padded_doubles;

    std::size_t count_ = 0;
    std::array<double, room> values_;
};

/// Sums `part` of the noise of each octave, with the octave's weight.
template <class Part>
double sum_of_octaves(const FractalNoise& noise, const Vec3& p, Part part) {
    const Octaves octaves(noise.octaves, p);
    double sum = 0, weight = 1;
    for (const double value : octaves.values()) {
        sum += weight * part(value);
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
