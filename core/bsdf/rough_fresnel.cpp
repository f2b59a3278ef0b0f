#include "core/bsdf/rough_fresnel.h"

namespace etalon {

Color mean_reflectance(const Fresnel& fresnel, const TrowbridgeReitz& facets, const Vec3f& wo) {
    const float alpha = std::min(1.0F, facets.mean_alpha());
    const float cos = std::sqrt(wo.z * wo.z + 0.36F * alpha);
    const float spread = 0.25F * std::sqrt(alpha);
    const auto term = [&](float c) {
        return reflectance(fresnel, std::copysign(std::min(c, 1.0F), wo.z));
    };
    return (term(cos - spread) + term(cos + spread)) / 2;
}

}  // namespace etalon
