// Reflectance of smooth interfaces for unpolarised light.
#pragma once

#include <variant>

#include "core/bsdf/disney_fresnel.h"

namespace etalon {

/// Returns the reflectance of an interface of dielectrics by Fresnel's equations. `eta` is the
/// index below the surface over the one above; `cos_incident` is the cosine of the angle to the
/// normal, negative for light from below. 1 for total internal reflection.
float dielectric_reflectance(float cos_incident, float eta);

/// Returns the reflectance of a conductor of the complex index eta + i k, relative to that above
/// it, by Fresnel's equations; `cos_incident` in [0, 1].
Color conductor_reflectance(float cos_incident, const Color& eta, const Color& k);

/// Reflects everything.
struct NoFresnel {
    Color operator()(float) const { return Color(1); }
};

struct DielectricFresnel {
    float eta;  ///< index below over index above
    Color operator()(float cos_incident) const {
        return Color(dielectric_reflectance(cos_incident, eta));
    }
};

struct ConductorFresnel {
    Color eta, k;
    Color operator()(float cos_incident) const {
        return conductor_reflectance(std::abs(cos_incident), eta, k);
    }
};

using Fresnel = std::variant<NoFresnel, DielectricFresnel, ConductorFresnel, DisneyFresnel>;

inline Color reflectance(const Fresnel& fresnel, float cos_incident) {
    return std::visit([&](const auto& kind) { return kind(cos_incident); }, fresnel);
}

}  // namespace etalon
