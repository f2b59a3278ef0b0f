#pragma once

#include "core/bsdf/evaluation.h"
#include "core/bsdf/lobe_kind.h"
#include "core/bsdf/local_direction.h"

namespace etalon {

/// Reflection by Lambertian microfacets: Oren and Nayar 1994, "Generalization of Lambert's
/// Reflectance Model", their qualitative model.
class OrenNayarReflection {
  public:
    static constexpr LobeKind kind = LobeKind::reflection;

    /// `sigma` is the standard deviation of the facets' angles, in degrees.
    OrenNayarReflection(const Color& reflectance, float sigma);

    Evaluation evaluate(const Vec3f& wo, const Vec3f& wi) const;
    std::optional<Vec3f> sample(const Vec3f& wo, const Vec2& uv) const {
        return cosine_direction(wo, uv);
    }
    Color albedo(const Vec3f&) const { return reflectance_; }
    void scale(const Color& by) { reflectance_ *= by; }

  private:
    Color reflectance_;
    float a_, b_;
};

}  // namespace etalon
