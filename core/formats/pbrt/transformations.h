// Matrices of pbrt-v3's transformations.
#pragma once

#include <optional>
#include <span>

#include "core/formats/pbrt/matrix4.h"
#include "core/numerics/vec.h"

namespace etalon::pbrt {

Matrix4 translation(const Vec3& offset);
Matrix4 scaling(const Vec3& factors);

/// Returns nothing for an axis without length.
std::optional<Matrix4> rotation(double degrees, const Vec3& axis);

/// Transforms the world to a camera at `eye` that sees `at` along its z axis. Returns nothing where
/// these are one point, or `up` is along the view.
std::optional<Matrix4> look_at(const Vec3& eye, const Vec3& at, const Vec3& up);

/// Matrix whose elements are given column by column.
Matrix4 from_columns(std::span<const double, 16> elements);

}  // namespace etalon::pbrt
