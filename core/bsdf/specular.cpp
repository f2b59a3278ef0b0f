#include "core/bsdf/specular.h"

namespace etalon {
namespace {

Vec3 mirrored(const Vec3& wo) {
    return {-wo.x, -wo.y, wo.z};
}

/// Refracts by Snell's law. `eta` is the index beyond the surface over that on the side of `wo`.
/// Nothing for total internal reflection.
std::optional<Vec3> refracted(const Vec3& wo, double eta) {
    if (eta == 1) return -wo;
    const double sine_squared = (wo.x * wo.x + wo.y * wo.y) / (eta * eta);
    if (sine_squared >= 1) return {};
    return Vec3(-wo.x / eta, -wo.y / eta, -std::copysign(std::sqrt(1 - sine_squared), wo.z));
}

/// Returns the transmitted light, which is `transmittance` of it.
std::optional<SpecularSample> transmitted(const Vec3& wo, float eta, const Color& transmittance,
                                          float probability) {
    const float beyond = wo.z > 0 ? eta : 1 / eta;
    const std::optional<Vec3> wi = refracted(wo, beyond);
    if (!wi) return {};
    return SpecularSample{*wi, transmittance / (beyond * beyond), probability, true, beyond};
}

}  // namespace

std::optional<SpecularSample> SpecularReflection::sample(const Vec3& wo, double) const {
    return SpecularSample{mirrored(wo), albedo(Vec3f(wo)), 1, false, 1};
}

std::optional<SpecularSample> SpecularTransmission::sample(const Vec3& wo, double) const {
    return transmitted(wo, eta, albedo(Vec3f(wo)), 1);
}

std::optional<SpecularSample> FresnelSpecular::sample(const Vec3& wo, double choice) const {
    const float f = dielectric_reflectance(static_cast<float>(wo.z), eta);
    const float reflected = f * mean(reflectance),
                total = reflected + (1 - f) * mean(transmittance);
    if (total == 0) return {};
    const float probability = reflected / total;
    if (choice < probability) {
        return SpecularSample{mirrored(wo), f * reflectance, probability, false, 1};
    }
    return transmitted(wo, eta, (1 - f) * transmittance, 1 - probability);
}

}  // namespace etalon
