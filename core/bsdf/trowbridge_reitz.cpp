#include "core/bsdf/trowbridge_reitz.h"

namespace etalon {

// Eto and Tokuyoshi 2023, "Bounded VNDF Sampling for Smith-GGX Reflections".
float TrowbridgeReitz::bound(const Vec3f& w) const {
    const float alpha = std::min({alpha_x_, alpha_y_, 1.0F}), alpha2 = alpha * alpha;
    const float s = 1 + std::sqrt(sine_squared(w)), s2 = s * s;
    return (1 - alpha2) * s2 / (s2 + alpha2 * w.z * w.z);
}

// Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps": stretched to the
// unit sphere, the mirror images of `w` about the visible normals fill a cap evenly.
Vec3f TrowbridgeReitz::sample(const Vec3f& w, const Vec2& uv, float bound) const {
    const float side = std::copysign(1.0F, w.z);
    const Vec3f pole = normalized(Vec3f(alpha_x_ * w.x, alpha_y_ * w.y, w.z) * side);
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(uv.x);
    const float rim = bound * pole.z;
    const float z = (1 - static_cast<float>(uv.y)) * (1 + rim) - rim;
    const float sine = std::sqrt(std::max(0.0F, 1 - z * z));
    const Vec3f m = pole + Vec3f(sine * std::cos(angle), sine * std::sin(angle), z);
    return side * normalized(Vec3f(alpha_x_ * m.x, alpha_y_ * m.y, m.z));
}

Vec3f TrowbridgeReitz::sample_reflected(const Vec3f& w, const Vec2& uv) const {
    const Vec3f m = sample(w, uv, bound(w));
    return normalized(2 * w.dot(m) * m - w);
}

float alpha_of_roughness(float roughness) {
    const float x = std::log(std::max(roughness, 1e-3F));
    return 1.62142F + x * (0.819955F + x * (0.1734F + x * (0.0171201F + x * 0.000640711F)));
}

}  // namespace etalon
