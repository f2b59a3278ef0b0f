#include "core/scene/instance.h"

#include "core/numerics/double_double.h"
#include "core/numerics/instruction_sets.h"
#include "core/numerics/rounding.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/scene/instance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Compiled for each instruction set, as the fused multiply-add of most is one instruction, but a
// call where it may be missing.
HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

HWY_INLINE TwoTerm minor(double a, double b, double c, double d) {
    return two_product(a, d) + -two_product(b, c);
}

HWY_INLINE Vec3TwoTerm fine_cross(const Vec3& a, const Vec3& b) {
    return {minor(a.y, a.z, b.y, b.z), minor(a.z, a.x, b.z, b.x), minor(a.x, a.y, b.x, b.y)};
}

HWY_INLINE double quotient(const TwoTerm& a, const TwoTerm& b) {
    const double value = a.value / b.value;
    const TwoTerm rest = a + -(TwoTerm{value, 0} * b);
    return value + rest.value / b.value;
}

/// Returns the rows of the inverse of the matrix with columns x, y and z, by Cramer's rule. The
/// columns are first scaled, exactly, so that no product leaves the range of double.
std::array<Vec3, 3> inverse_rows(const Vec3& x, const Vec3& y, const Vec3& z) {
    const double scale = power_of_two_reciprocal(std::max({max_abs(x), max_abs(y), max_abs(z)}));
    const Vec3 a = x * scale, b = y * scale, c = z * scale;
    const std::array<Vec3TwoTerm, 3> cofactors = {fine_cross(b, c), fine_cross(c, a),
                                                  fine_cross(a, b)};
    const Vec3TwoTerm& bc = cofactors[0];
    const TwoTerm determinant =
        TwoTerm{a.x, 0} * bc[0] + TwoTerm{a.y, 0} * bc[1] + TwoTerm{a.z, 0} * bc[2];
    std::array<Vec3, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            rows[i][k] = quotient(cofactors[i][static_cast<std::size_t>(k)], determinant) * scale;
        }
    }
    return rows;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(inverse_rows);

Instance::Instance(const Affine& to_world, std::uint32_t object_number)
    : rows(HWY_DYNAMIC_DISPATCH(inverse_rows)(to_world.x, to_world.y, to_world.z)),
      origin(to_world.origin),
      object(object_number) {
    if (!exists()) rows.fill(Vec3(nan_value));  // so that no ray in the object's space is valid
}

/// Uses Cramer's rule in double. Its error for an ill-conditioned map is measured where it matters.
Affine Instance::to_world() const {
    const double scale =
        power_of_two_reciprocal(std::max({max_abs(rows[0]), max_abs(rows[1]), max_abs(rows[2])}));
    const Vec3 a = rows[0] * scale, b = rows[1] * scale, c = rows[2] * scale;
    const Vec3 bc = b.cross(c);
    const double factor = scale / a.dot(bc);
    return {factor * bc, factor * c.cross(a), factor * a.cross(b), origin};
}

bool Instance::exists() const {
    return is_finite(to_world());
}

}  // namespace etalon
#endif
