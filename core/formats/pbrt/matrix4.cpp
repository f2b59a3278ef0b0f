#include "core/formats/pbrt/matrix4.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace etalon::pbrt {
namespace {

/// Returns the row, at or below `column`, with the largest element in that column.
std::size_t pivot_row(const Matrix4& m, std::size_t column) {
    std::size_t best = column;
    for (std::size_t r = column + 1; r < 4; ++r) {
        if (std::abs(m[r][column]) > std::abs(m[best][column])) best = r;
    }
    return best;
}

void subtract(std::array<double, 4>& row, double factor, const std::array<double, 4>& other) {
    for (std::size_t c = 0; c < 4; ++c) row[c] -= factor * other[c];
}

}  // namespace

Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
    Matrix4 product;
    for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t c = 0; c < 4; ++c) {
            product[r][c] =
                a[r][0] * b[0][c] + a[r][1] * b[1][c] + a[r][2] * b[2][c] + a[r][3] * b[3][c];
        }
    }
    return product;
}

// Gauss-Jordan elimination with partial pivoting.
std::optional<Matrix4> inverse(const Matrix4& m) {
    Matrix4 left = m, right;
    for (std::size_t c = 0; c < 4; ++c) {
        const std::size_t pivot = pivot_row(left, c);
        if (left[pivot][c] == 0) return std::nullopt;
        std::swap(left[pivot], left[c]);
        std::swap(right[pivot], right[c]);
        for (std::size_t k = 0; k < 4; ++k) right[c][k] /= left[c][c];
        for (std::size_t k = 4; k-- > c;) left[c][k] /= left[c][c];
        for (std::size_t r = 0; r < 4; ++r) {
            if (r == c) continue;
            const double factor = left[r][c];
            subtract(left[r], factor, left[c]);
            subtract(right[r], factor, right[c]);
        }
    }
    if (!is_finite(right)) return std::nullopt;
    return right;
}

bool is_finite(const Matrix4& m) {
    return std::ranges::all_of(m.rows, [](const auto& row) {
        return std::ranges::all_of(row, [](double x) { return std::isfinite(x); });
    });
}

bool is_affine(const Matrix4& m) {
    return m[3] == std::array<double, 4>{0, 0, 0, 1};
}

}  // namespace etalon::pbrt
