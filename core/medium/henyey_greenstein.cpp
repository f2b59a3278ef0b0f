#include "core/medium/henyey_greenstein.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etalon {

float HenyeyGreenstein::value(double cosine) const {
    const double root2 = 1 + g_ * g_ - 2 * g_ * cosine;
    return static_cast<float>((1 - g_ * g_) / (4 * std::numbers::pi * root2 * std::sqrt(root2)));
}

/// Returns the cosine below which the fraction u of all directions lies.
double HenyeyGreenstein::cosine_at(double u) const {
    constexpr double isotropic = 1e-4;  // below it the quotient cancels, and is no better than this
    if (std::abs(g_) < isotropic) return 2 * u - 1;
    const double root = (1 - g_ * g_) / (1 - g_ + 2 * g_ * u);
    return std::clamp((1 + g_ * g_ - root * root) / (2 * g_), -1.0, 1.0);
}

Vec3 HenyeyGreenstein::sample(const Vec3& direction, const Vec2& uv) const {
    Vec3 x, y;
    orthonormal_basis(direction, x, y);
    const double cosine = cosine_at(uv.x), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double angle = 2 * std::numbers::pi * uv.y;
    return normalized(sine * std::cos(angle) * x + sine * std::sin(angle) * y + cosine * direction);
}

}  // namespace etalon
