#pragma once

#include "core/bsdf/fresnel.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/local_direction.h"

namespace etalon {

/// The direction that a specular lobe chose.
struct SpecularSample {
    Vec3 wi;            ///< local
    Color weight;       ///< the BSDF's value times |cos|, for this direction
    float probability;  ///< probability of this choice among the lobe's
    bool transmission;
    float eta;  ///< index on the side of `wi` over that on the side of `wo`
};

/// A smooth mirror.
struct SpecularReflection {
    static constexpr LobeKind kind = LobeKind::specular;
    Color reflectance;
    Fresnel fresnel;

    std::optional<SpecularSample> sample(const Vec3& wo, double choice) const;
    Color albedo(const Vec3f& wo) const { return reflectance * etalon::reflectance(fresnel, wo.z); }
    void scale(const Color& by) { reflectance *= by; }
};

/// Transmission through a smooth interface of dielectrics. Radiance is divided by eta^2 as the
/// solid angle of the light changes.
struct SpecularTransmission {
    static constexpr LobeKind kind = LobeKind::specular;
    Color transmittance;
    float eta;  ///< index below over index above; 1: all light passes straight through

    std::optional<SpecularSample> sample(const Vec3& wo, double choice) const;
    Color albedo(const Vec3f& wo) const {
        return transmittance * (eta == 1 ? 1 : 1 - dielectric_reflectance(wo.z, eta));
    }
    void scale(const Color& by) { transmittance *= by; }
};

/// A smooth interface of dielectrics: reflects or transmits.
struct FresnelSpecular {
    static constexpr LobeKind kind = LobeKind::specular;
    Color reflectance, transmittance;
    float eta;  ///< index below over index above

    std::optional<SpecularSample> sample(const Vec3& wo, double choice) const;
    Color albedo(const Vec3f& wo) const {
        const float f = dielectric_reflectance(wo.z, eta);
        return f * reflectance + (1 - f) * transmittance;
    }
    void scale(const Color& by) {
        reflectance *= by;
        transmittance *= by;
    }
};

}  // namespace etalon
