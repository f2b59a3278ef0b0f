#pragma once

#include <array>
#include <optional>

namespace etalon::pbrt {

/// 4x4 matrix, row by row, that transforms column vectors like pbrt-v3's: p' = M p.
struct Matrix4 {
    std::array<std::array<double, 4>, 4> rows = {
        {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

    std::array<double, 4>& operator[](std::size_t row) { return rows[row]; }
    const std::array<double, 4>& operator[](std::size_t row) const { return rows[row]; }
    bool operator==(const Matrix4&) const = default;
};

Matrix4 operator*(const Matrix4& a, const Matrix4& b);

/// Returns the inverse; nothing if the matrix is singular or the inverse is not finite.
std::optional<Matrix4> inverse(const Matrix4& m);

bool is_finite(const Matrix4& m);

/// Returns whether the last row is 0 0 0 1.
bool is_affine(const Matrix4& m);

}  // namespace etalon::pbrt
