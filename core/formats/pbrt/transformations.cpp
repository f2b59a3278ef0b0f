#include "core/formats/pbrt/transformations.h"

#include <cmath>
#include <numbers>

namespace etalon::pbrt {
namespace {

/// Returns the normalized vector; nothing for zero.
std::optional<Vec3> unit(const Vec3& v) {
    const double largest = max_abs(v);  // so that squares neither overflow nor vanish
    if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
    return normalized(v / largest);
}

Matrix4 from_axes(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin) {
    return {{{{x.x, y.x, z.x, origin.x},
              {x.y, y.y, z.y, origin.y},
              {x.z, y.z, z.z, origin.z},
              {0, 0, 0, 1}}}};
}

}  // namespace

Matrix4 translation(const Vec3& offset) {
    return from_axes({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, offset);
}

Matrix4 scaling(const Vec3& factors) {
    return from_axes({factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}, {0, 0, 0});
}

// Rodrigues' formula, for the images of the axes.
std::optional<Matrix4> rotation(double degrees, const Vec3& axis) {
    const std::optional<Vec3> a = unit(axis);
    if (!a) return std::nullopt;
    const double radians = degrees * (std::numbers::pi / 180);
    const double sine = std::sin(radians), cosine = std::cos(radians);
    const auto image = [&](const Vec3& v) {
        return v * cosine + a->cross(v) * sine + *a * (a->dot(v) * (1 - cosine));
    };
    return from_axes(image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1}), {0, 0, 0});
}

std::optional<Matrix4> look_at(const Vec3& eye, const Vec3& at, const Vec3& up) {
    const std::optional<Vec3> direction = unit(at - eye), unit_up = unit(up);
    if (!direction || !unit_up) return std::nullopt;
    const std::optional<Vec3> right = unit(unit_up->cross(*direction));
    if (!right) return std::nullopt;
    return inverse(from_axes(*right, direction->cross(*right), *direction, eye));
}

Matrix4 from_columns(std::span<const double, 16> elements) {
    Matrix4 m;
    for (std::size_t i = 0; i < 16; ++i) m[i % 4][i / 4] = elements[i];
    const double w = m[3][3];
    if (!(w > 0) || m[3] != std::array<double, 4>{0, 0, 0, w}) return m;
    for (auto& row : m.rows) {
        for (double& element : row) element /= w;
    }
    return m;
}

}  // namespace etalon::pbrt
