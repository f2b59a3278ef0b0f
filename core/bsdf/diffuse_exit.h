#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/fresnel.h"
#include "core/bsdf/fresnel_moments.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/local_direction.h"

namespace etalon {

/// Direction in which light enters that is then scattered below the surface until it is isotropic:
/// the transmittance of a smooth interface over its mean (Pharr, Jakob & Humphreys 2016, section
/// 11.4.2). Radiance was divided by eta^2 where the camera path entered, so it is multiplied by
/// eta^2 here.
struct DiffuseExit {
    static constexpr LobeKind kind = LobeKind::reflection;
    Color factor;
    float index;  ///< below over above

    /// Makes the lobe of an interface of that index; it is black for those too far from 1 for the
    /// mean's formula.
    explicit DiffuseExit(float below_over_above) : factor(0), index(below_over_above) {
        const float mean = 1 - 2 * fresnel_moment1(1 / index);
        if (mean > 0) factor = Color(index * index * inverse_pi / mean);
    }

    /// Directions beyond the shading horizon are those of light from below, as in pbrt-v3.
    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const {
        const float cos = wo.z > 0 ? wi.z : -wi.z;
        return {factor * (1 - dielectric_reflectance(cos, index)), std::abs(cos) * inverse_pi};
    }
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const {
        return cosine_direction(wo, uv);
    }
    Color albedo(const Vec3f&) const { return factor; }
    void scale(const Color& by) { factor *= by; }
};

}  // namespace etalon
