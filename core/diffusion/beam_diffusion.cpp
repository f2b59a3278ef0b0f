#include "core/diffusion/beam_diffusion.h"

#include <cmath>
#include <numbers>

#include "core/bsdf/fresnel.h"
#include "core/bsdf/fresnel_moments.h"

namespace etalon {
namespace {

constexpr int depths = 100;  ///< number of depths, distributed like the beam's scattering events
constexpr float inverse_4pi = std::numbers::inv_pi_v<float> / 4;

/// Returns depth number `i` of those, in mean free paths.
float free_paths(int i) {
    return -std::log(1 - (static_cast<float>(i) + 0.5F) / depths);
}

/// Returns Henyey & Greenstein's phase function (1941) of the angle between the beam and the way
/// back to the surface.
float phase(float cosine, float g) {
    const float d = 1 + g * g + 2 * g * cosine;
    return inverse_4pi * (1 - g * g) / (d * std::sqrt(d));
}

/// Diffusion in the medium with reduced (isotropic) scattering, after Grosjean 1956.
struct Diffusion {
    float albedo, extinction;  ///< reduced
    float coefficient;         ///< D
    float decay;               ///< sigma_tr
    float mirror;              ///< distance of the plane of the mirror sources from the surface
    float by_fluence, by_gradient;  ///< weights of the exitance

    explicit Diffusion(const HalfSpace& medium) {
        const float absorbed = 1 - medium.albedo, scattered = medium.albedo * (1 - medium.g);
        extinction = absorbed + scattered;
        albedo = scattered / extinction;
        coefficient = (2 * absorbed + scattered) / (3 * extinction * extinction);
        decay = std::sqrt(absorbed / coefficient);
        const float m1 = fresnel_moment1(medium.eta), m2 = fresnel_moment2(medium.eta);
        mirror = 2 * coefficient * (1 + 3 * m2) / (1 - 2 * m1);
        by_fluence = 0.25F * (1 - 2 * m1);
        by_gradient = 0.5F * (1 - 3 * m2);
    }

    /// Returns the exitance from a source at a depth and its mirror image.
    float of_dipole(float depth, float distance) const {
        const float image = -depth - 2 * mirror;
        const float to_depth = std::sqrt(distance * distance + depth * depth);
        const float to_image = std::sqrt(distance * distance + image * image);
        const float here = std::exp(-decay * to_depth), there = std::exp(-decay * to_image);
        const float fluence = inverse_4pi / coefficient * (here / to_depth - there / to_image);
        const auto gradient = [&](float z, float d, float decayed) {
            return z * (1 + decay * d) * decayed / (d * d * d);
        };
        const float irradiance =
            inverse_4pi * (gradient(depth, to_depth, here) - gradient(image, to_image, there));
        // Less near the beam, where light has not spread yet.
        const float spread = 1 - std::exp(-2 * extinction * (to_depth + depth));
        return spread * albedo * albedo * (fluence * by_fluence + irradiance * by_gradient);
    }
};

}  // namespace

float multiple_scattering(const HalfSpace& medium, float distance) {
    const Diffusion diffusion(medium);
    float sum = 0;
    for (int i = 0; i < depths; ++i) {
        sum += diffusion.of_dipole(free_paths(i) / diffusion.extinction, distance);
    }
    return sum / depths;
}

float single_scattering(const HalfSpace& medium, float distance) {
    // Above this depth all light is totally reflected at the interface.
    const float least = distance * std::sqrt(std::max(0.0F, medium.eta * medium.eta - 1));
    float sum = 0;
    for (int i = 0; i < depths; ++i) {
        const float depth = least + free_paths(i);
        const float way = std::sqrt(distance * distance + depth * depth), cosine = depth / way;
        sum += medium.albedo * std::exp(-(way + least)) / (way * way) * phase(cosine, medium.g) *
               (1 - dielectric_reflectance(-cosine, medium.eta)) * cosine;
    }
    return sum / depths;
}

}  // namespace etalon
