#include "core/bsdf/fresnel.h"

namespace etalon {

float dielectric_reflectance(float cos_incident, float eta) {
    const float relative = cos_incident > 0 ? eta : 1 / eta;
    const float cos_i = std::min(std::abs(cos_incident), 1.0F);
    const float sine_squared_t = (1 - cos_i * cos_i) / (relative * relative);
    if (sine_squared_t >= 1) return 1;
    const float cos_t = std::sqrt(1 - sine_squared_t);
    const float parallel = (relative * cos_i - cos_t) / (relative * cos_i + cos_t);
    const float perpendicular = (cos_i - relative * cos_t) / (cos_i + relative * cos_t);
    return (parallel * parallel + perpendicular * perpendicular) / 2;
}

namespace {

/// Returns one channel, with the terms of Lagarde 2013 ("Memo on Fresnel equations").
float conductor_channel(float cos_i, float eta, float k) {
    const float cos2 = cos_i * cos_i, sin2 = 1 - cos2;
    const float t0 = eta * eta - k * k - sin2;
    const float a2_plus_b2 = std::sqrt(t0 * t0 + 4 * eta * eta * k * k);
    const float a = std::sqrt(std::max(0.0F, (a2_plus_b2 + t0) / 2));
    const float t1 = a2_plus_b2 + cos2, t2 = 2 * cos_i * a;
    const float t3 = cos2 * a2_plus_b2 + sin2 * sin2, t4 = t2 * sin2;
    const float perpendicular = (t1 - t2) / (t1 + t2);
    return perpendicular * (1 + (t3 - t4) / (t3 + t4)) / 2;
}

}  // namespace

Color conductor_reflectance(float cos_incident, const Color& eta, const Color& k) {
    // With larger ones, which are mirrors as well, fourth powers are beyond floats.
    constexpr float most = 1e9F;
    const float cos_i = std::min(cos_incident, 1.0F);
    const auto channel = [&](float n, float absorbed) {
        return conductor_channel(cos_i, std::min(n, most), std::min(absorbed, most));
    };
    return {channel(eta.x, k.x), channel(eta.y, k.y), channel(eta.z, k.z)};
}

Color DisneyFresnel::operator()(float cos_incident) const {
    const float w = schlick_weight(cos_incident);
    const float dielectric = (1 - metallic) * dielectric_reflectance(cos_incident, eta);
    return Color(dielectric) + metallic * ((1 - w) * from_above + Color(w));
}

}  // namespace etalon
