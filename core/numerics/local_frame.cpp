#include "core/numerics/local_frame.h"

#include "core/numerics/double_double.h"
#include "core/numerics/dyadic_vec.h"

namespace etalon {
namespace {

/// A matrix as its rows or columns.
using Matrix = std::array<Vec3TwoTerm, 3>;

/// A rotation in a plane, good to 2^-100.
struct Rotation {
    TwoTerm cosine{1, 0}, sine{0, 0};
};

/// Returns the rotation that makes two vectors orthogonal (Jacobi's, applied to one side of a
/// matrix as by Hestenes 1958), or the identity if they nearly are.
Rotation rotation_to_right_angles(Vec3 a, Vec3 b) {
    const double scale = power_of_two_reciprocal(std::max(max_abs(a), max_abs(b)));
    a *= scale, b *= scale;
    const double aa = a.dot(a), bb = b.dot(b), ab = a.dot(b);
    constexpr double near_enough = 0x1p-10;
    if (!(ab * ab > near_enough * near_enough * aa * bb)) return {};
    const double zeta = (bb - aa) / (2 * ab);
    const double tangent = std::copysign(1, zeta) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
    const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
    const TwoTerm minus_square = -two_product(sine, sine);
    const TwoTerm rest = TwoTerm{1, 0} + minus_square + -two_product(cosine, cosine);
    return {two_sum(cosine, rest.value / (2 * cosine)), {sine, 0}};
}

void rotate(const Rotation& r, Vec3TwoTerm& a, Vec3TwoTerm& b) {
    for (int k = 0; k < 3; ++k) {
        const TwoTerm before = a[k];
        a[k] = r.cosine * before + -(r.sine * b[k]);
        b[k] = r.sine * before + r.cosine * b[k];
    }
}

/// Rotates the unit shape until the rows of the inverse are orthogonal. Returns whether it had to.
bool turn(Matrix& rows, Matrix& columns, int i, int j) {
    const Rotation r = rotation_to_right_angles(rounded(rows[i]), rounded(rows[j]));
    rotate(r, rows[i], rows[j]);
    rotate(r, columns[i], columns[j]);
    return r.sine.value != 0;
}

void turn(Matrix& rows, Matrix& columns, Symmetry symmetry) {
    constexpr int enough = 20;
    bool turned = symmetry != Symmetry::none;
    for (int sweep = 0; turned && sweep < enough; ++sweep) {
        turned = turn(rows, columns, 0, 1);
        if (symmetry == Symmetry::about_z) continue;
        turned |= turn(rows, columns, 1, 2);
        turned |= turn(rows, columns, 2, 0);
    }
}

double quotient(const Dyadic& a, const Dyadic& b) {
    return a.sign() * b.sign() * static_cast<double>(a.magnitude() / b.magnitude());
}

TwoTerm fine_quotient(const Dyadic& a, const Dyadic& b) {
    const double value = quotient(a, b);
    if (!std::isfinite(value)) return {value, 0};
    return two_sum(value, quotient(a - Dyadic(value) * b, b));
}

Vec3TwoTerm fine_quotient(const DyadicVec& a, const Dyadic& b) {
    return {fine_quotient(a[0], b), fine_quotient(a[1], b), fine_quotient(a[2], b)};
}

double length_above(const Vec3& v) {
    return (1 + 8 * unit_roundoff) * std::hypot(v.x, v.y, v.z);
}

}  // namespace

/// Computes the inverse by Cramer's rule.
LocalFrame::LocalFrame(const Affine& map, Symmetry symmetry) : to_world_(map) {
    if (!is_finite(map)) return;
    const DyadicVec a = exactly(map.x), b = exactly(map.y), c = exactly(map.z);
    const DyadicVec bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Dyadic determinant = dot(a, bc);
    if (determinant.sign() == 0) return;
    Matrix rows = {fine_quotient(bc, determinant), fine_quotient(ca, determinant),
                   fine_quotient(ab, determinant)};
    Matrix columns = {two_terms(map.x), two_terms(map.y), two_terms(map.z)};
    turn(rows, columns, symmetry);
    to_world_ = {rounded(columns[0]), rounded(columns[1]), rounded(columns[2]), map.origin};
    for (int k = 0; k < 3; ++k) {
        rows_[k] = rounded(rows[k]);
        lengths_[k] = length_above(rows_[k]);
    }
    exists_ = true;
}

}  // namespace etalon
