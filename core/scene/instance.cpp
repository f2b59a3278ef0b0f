#include "core/scene/instance.h"

#include "core/numerics/double_double.h"
#include "core/numerics/instruction_sets.h"
#include "core/numerics/rounding.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/scene/instance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/two_sum_lanes-inl.h"

// Compiled for each instruction set, as the fused multiply-add of most is one instruction, but a
// call where it may be missing.
HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Rows of a matrix in lanes: all three, or in turns where vectors are shorter.
using RowsTag = hn::CappedTag<double, 4>;
using RowLanes = hn::Vec<RowsTag>;

/// A number for each row; the fourth means nothing.
struct Rows {
    HWY_INLINE RowLanes lanes(std::size_t first) const { return hn::Load(RowsTag(), &rows[first]); }
    HWY_INLINE void set(std::size_t first, RowLanes lanes) {
        hn::Store(lanes, RowsTag(), &rows[first]);
    }

    alignas(32) double rows[4];
};

/// Double-double numbers with the operations of core/numerics/double_double.h.
using TwoTermRows = TwoTermLanes<RowLanes>;

HWY_INLINE RowLanes set(double x) {
    return hn::Set(RowsTag(), x);
}

HWY_INLINE TwoTermRows two_product(RowLanes a, RowLanes b) {
    const RowLanes p = a * b;
    if constexpr (HWY_NATIVE_FMA != 0) return {p, hn::MulSub(a, b, p)};
    Rows x, y, error;
    x.set(0, a), y.set(0, b), error.set(0, p);
    for (std::size_t i = 0; i < hn::Lanes(RowsTag()); ++i) {
        error.rows[i] = std::fma(x.rows[i], y.rows[i], -error.rows[i]);
    }
    return {p, error.lanes(0)};
}

HWY_INLINE TwoTermRows difference(const TwoTermRows& a, const TwoTermRows& b) {
    const TwoTermRows s = two_sum(a.value, hn::Neg(b.value));
    return two_sum(s.value, s.error + (a.error - b.error));
}

/// Returns the product of a double and a double-double number.
HWY_INLINE TwoTermRows product(RowLanes a, const TwoTerm& b) {
    const TwoTermRows p = two_product(a, set(b.value));
    return two_sum(p.value, p.error + (a * set(b.error) + set(0) * set(b.value)));
}

HWY_INLINE RowLanes quotient(const TwoTermRows& a, const TwoTerm& b) {
    const RowLanes value = a.value / set(b.value);
    const TwoTermRows rest = difference(a, product(value, b));
    return value + rest.value / set(b.value);
}

/// Cross products of a pair of vectors for each row, as the values and errors of their components.
struct CrossProducts {
    /// Row i is the cross product of a[i] and b[i].
    HWY_INLINE CrossProducts(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
        const std::array<Rows, 3> first = columns(a), second = columns(b);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t y = (k + 1) % 3, z = (k + 2) % 3;
            for (std::size_t i = 0; i < 3; i += hn::Lanes(RowsTag())) {
                set(k, i,
                    difference(two_product(first[y].lanes(i), second[z].lanes(i)),
                               two_product(first[z].lanes(i), second[y].lanes(i))));
            }
        }
    }

    HWY_INLINE static std::array<Rows, 3> columns(const std::array<Vec3, 3>& v) {
        std::array<Rows, 3> result;
        for (int k = 0; k < 3; ++k) {
            result[static_cast<std::size_t>(k)] = {{v[0][k], v[1][k], v[2][k], v[0][k]}};
        }
        return result;
    }
    HWY_INLINE void set(std::size_t k, std::size_t first, const TwoTermRows& lanes) {
        value[k].set(first, lanes.value);
        error[k].set(first, lanes.error);
    }
    HWY_INLINE TwoTermRows lanes(std::size_t k, std::size_t first) const {
        return {value[k].lanes(first), error[k].lanes(first)};
    }
    HWY_INLINE TwoTerm at(std::size_t row, std::size_t k) const {
        return {value[k].rows[row], error[k].rows[row]};
    }

    std::array<Rows, 3> value, error;  ///< by component
};

/// Returns the rows of the inverse of the matrix with columns x, y and z, by Cramer's rule. The
/// columns are first scaled, exactly, so that no product leaves the range of double.
std::array<Vec3, 3> inverse_rows(const Vec3& x, const Vec3& y, const Vec3& z) {
    const double scale = power_of_two_reciprocal(std::max({max_abs(x), max_abs(y), max_abs(z)}));
    const Vec3 a = x * scale, b = y * scale, c = z * scale;
    const CrossProducts cofactors({b, c, a}, {c, a, b});
    const TwoTerm determinant = TwoTerm{a.x, 0} * cofactors.at(0, 0) +
                                TwoTerm{a.y, 0} * cofactors.at(0, 1) +
                                TwoTerm{a.z, 0} * cofactors.at(0, 2);
    std::array<Vec3, 3> rows;
    for (std::size_t k = 0; k < 3; ++k) {
        Rows column;
        for (std::size_t i = 0; i < 3; i += hn::Lanes(RowsTag())) {
            column.set(i, quotient(cofactors.lanes(k, i), determinant) * set(scale));
        }
        for (std::size_t i = 0; i < 3; ++i) rows[i][static_cast<int>(k)] = column.rows[i];
    }
    return rows;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(inverse_rows);

namespace {

/// The columns of the inverse of a matrix by Cramer's rule in double. The rows are first scaled,
/// exactly, to numbers of at most 2.
class ColumnsByCramer {
  public:
    explicit ColumnsByCramer(const std::array<Vec3, 3>& rows)
        : scale_(power_of_two_reciprocal(
              std::max({max_abs(rows[0]), max_abs(rows[1]), max_abs(rows[2])}))),
          a_(rows[0] * scale_),
          b_(rows[1] * scale_),
          c_(rows[2] * scale_),
          bc_(b_.cross(c_)),
          determinant_(a_.dot(bc_)) {
        const Vec3 b = abs(b_), c = abs(c_);
        terms_ = abs(a_).dot({b.y * c.z + b.z * c.y, b.z * c.x + b.x * c.z, b.x * c.y + b.y * c.x});
    }

    /// Returns whether the magnitudes of the determinant's terms sum to more than `factor` times
    /// the determinant, whose relative error is 5 u times their quotient.
    bool cancels_more_than(double factor) const { return terms_ > factor * std::abs(determinant_); }

    /// Returns whether that sum is so small that bits of it may be below the range of double.
    bool is_out_of_range() const { return terms_ < 0x1p-900; }

    Affine map(const Vec3& origin) const {
        const double factor = scale_ / determinant_;
        return {factor * bc_, factor * c_.cross(a_), factor * a_.cross(b_), origin};
    }

    /// Returns the same, rounded once. The inverse of the transpose has the columns as its rows.
    Affine rounded_map(const Vec3& origin) const {
        const auto columns = HWY_DYNAMIC_DISPATCH(inverse_rows)(a_, b_, c_);
        return {scale_ * columns[0], scale_ * columns[1], scale_ * columns[2], origin};
    }

  private:
    double scale_;
    Vec3 a_, b_, c_, bc_;
    double determinant_, terms_;
};

}  // namespace

Instance::Instance(const Affine& to_world, std::uint32_t object_number)
    : rows(HWY_DYNAMIC_DISPATCH(inverse_rows)(to_world.x, to_world.y, to_world.z)),
      origin(to_world.origin),
      object(object_number) {
    if (!exists()) rows.fill(Vec3(nan_value));  // so that no ray in the object's space is valid
}

Affine Instance::to_world() const {
    const ColumnsByCramer inverse(rows);
    return inverse.cancels_more_than(0x1p16) ? inverse.rounded_map(origin) : inverse.map(origin);
}

/// The sum of the determinant's terms is at most 2.6 S^2 times the determinant for a spread S:
/// scale the rows, which changes neither, so that |A| v = v for v = (1, 1, 1). Then the terms sum
/// to at most 1. The rows of the inverse are no longer than S, so the product of its two larger
/// singular values is at most 1.5 S^2, and the third is at most sqrt(3), as no row of A is shorter
/// than 1 / sqrt(3). Their product is the inverse's determinant.
std::optional<Affine> Instance::precise_to_world() const {
    const ColumnsByCramer inverse(rows);
    if (inverse.is_out_of_range() || inverse.cancels_more_than(0x1p46)) return std::nullopt;
    return inverse.cancels_more_than(2) ? inverse.rounded_map(origin) : inverse.map(origin);
}

bool Instance::exists() const {
    return is_finite(to_world());
}

}  // namespace etalon
#endif
