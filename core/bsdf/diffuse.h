#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/local_direction.h"

namespace etalon {

/// Lambertian reflection: the same radiance in all directions.
struct LambertReflection {
    static constexpr LobeKind kind = LobeKind::reflection;
    Color reflectance;

    Evaluation evaluate(const Vec3f&, const Vec3f& wi) const {
        return {reflectance * inverse_pi, std::abs(wi.z) * inverse_pi};
    }
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const {
        return cosine_direction(wo, uv);
    }
    Color albedo(const Vec3f&) const { return reflectance; }
    void scale(const Color& by) { reflectance *= by; }
};

/// Lambertian transmission to the other side.
struct LambertTransmission {
    static constexpr LobeKind kind = LobeKind::transmission;
    Color transmittance;

    Evaluation evaluate(const Vec3f&, const Vec3f& wi) const {
        return {transmittance * inverse_pi, std::abs(wi.z) * inverse_pi};
    }
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const {
        return cosine_direction(-wo, uv);
    }
    Color albedo(const Vec3f&) const { return transmittance; }
    void scale(const Color& by) { transmittance *= by; }
};

}  // namespace etalon
