// Matrices of pbrt-v3's transformations.
#pragma once

#include <optional>
#include <span>

#include "core/formats/pbrt/matrix4.h"
#include "core/numerics/vec.h"

namespace etalon::pbrt {

Matrix4 translation(const Vec3& offset);
Matrix4 scaling(const Vec3& factors);

/// Returns a rotation; nothing for an axis of zero length.
std::optional<Matrix4> rotation(double degrees, const Vec3& axis);

/// Returns the transform from the world to a camera at `eye` that sees `at` along its z axis.
/// Nothing if these are one point, or if `up` is along the view.
std::optional<Matrix4> look_at(const Vec3& eye, const Vec3& at, const Vec3& up);

/// Returns the matrix whose elements are given column by column. If its last row is 0 0 0 w with a
/// positive w, it is divided by w, which makes it affine: points are divided by theirs.
Matrix4 from_columns(std::span<const double, 16> elements);

}  // namespace etalon::pbrt
