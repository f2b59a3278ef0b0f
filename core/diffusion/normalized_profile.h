#pragma once

#include <cmath>
#include <numbers>

#include "core/numerics/vec.h"

namespace etalon {

/// Christensen & Burley 2015, "Approximate Reflectance Profiles for Efficient Subsurface
/// Scattering": two exponentials, whose integral over a plane is the albedo.
class NormalizedProfile {
  public:
    /// `distance` is the mean distance of light in Burley's model, for each channel; not below 0.
    /// With 0 no light leaves.
    NormalizedProfile(const Color& albedo, const Color& distance)
        : albedo_(albedo), scale_(part_of_distance * distance) {}

    float value(int channel, float distance) const {
        return albedo_[channel] * density(channel, distance);
    }

    float density(int channel, float distance) const {
        const float d = scale_[channel], r = std::max(distance, least * d);
        if (!(d > 0)) return 0;
        return (std::exp(-r / d) + std::exp(-r / (3 * d))) /
               (8 * std::numbers::pi_v<float> * d * r);
    }

    float sample(int channel, double u) const {
        const float d = scale_[channel];
        if (!(d > 0)) return -1;
        // The first exponential has a quarter of the light.
        const bool is_first = u < 0.25;
        const double rest = is_first ? 4 * u : (u - 0.25) / 0.75;
        return static_cast<float>(-(is_first ? 1 : 3) * d * std::log1p(-rest));
    }

  private:
    static constexpr float part_of_distance = 0.2F;  ///< pbrt-v3's, from its authors
    static constexpr float least = 1e-6F;            ///< the value is infinite at a distance of 0

    Color albedo_, scale_;
};

}  // namespace etalon
