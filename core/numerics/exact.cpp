#include "core/numerics/exact.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "core/numerics/double_double.h"
#include "core/numerics/dyadic_vec.h"

namespace etalon {
namespace {

using Difference = Expansion<2>;

/// Returns d . (p x q), exactly.
double exact_triple_product(const Vec3TwoTerm& d, const Vec3TwoTerm& p, const Vec3TwoTerm& q) {
    const auto minor = [&](int i, int j) {
        const Difference pi(p[i]), pj(p[j]), qi(q[i]), qj(q[j]);
        return pi * qj - pj * qi;
    };
    const auto volume = Difference(d[0]) * minor(1, 2) + Difference(d[1]) * minor(2, 0) +
                        Difference(d[2]) * minor(0, 1);
    return volume.estimate();
}

/// Returns whether two vectors of single terms are parallel. Early out: rays that are aimed at a
/// corner often pass through it exactly.
bool are_parallel(const Vec3TwoTerm& d, const Vec3TwoTerm& p) {
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if (d[k].error != 0 || p[k].error != 0) return false;
        const TwoTerm a = two_product(d[i].value, p[j].value);
        const TwoTerm b = two_product(d[j].value, p[i].value);
        if (a.value != b.value || a.error != b.error) return false;
    }
    return true;
}

/// Returns whether products whose magnitudes sum up to `terms`, and their rounding errors, are in
/// the range of double.
bool is_in_range(double terms) {
    return terms > 0x1p-800 && terms < infinity;
}

/// Returns the least term that is not 0; infinity where all are.
double least_term(const TwoTerm& x) {
    if (x.error != 0) return std::abs(x.error);
    return x.value != 0 ? std::abs(x.value) : infinity;
}
double least_term(const Vec3TwoTerm& v) {
    return std::min({least_term(v[0]), least_term(v[1]), least_term(v[2])});
}

/// Returns whether products of such terms keep all their bits, given the product of the least term
/// of each factor. The lowest bit of three factors is at least 2^-156 of that, and may still be
/// multiplied by a direction of usual length.
bool keep_all_bits(double product_of_least) {
    return product_of_least > 0x1p-700;
}

template <class... Numbers>
bool are_finite(const Numbers&... x) {
    return (std::isfinite(x) && ...);
}

/// Returns the nearest finite double of that sign, at least `least` in magnitude; 0 for zero.
double finite(const Dyadic& x, double least = std::numeric_limits<double>::min()) {
    if (x.sign() == 0) return 0;
    return x.sign() * std::clamp(std::abs(x.rounded()), least, std::numeric_limits<double>::max());
}

/// Bound on the error of a triple product in double-double, relative to its terms.
constexpr double triple_product_error_bound = 0x1p-101;

/// Returns the triple product in double-double if its relative error is at most `tolerance`.
/// Nothing if products leave the range of double.
std::optional<double> triple_product(const Vec3TwoTerm& d, const Vec3TwoTerm& p,
                                     const Vec3TwoTerm& q, double tolerance) {
    TwoTerm volume{0, 0};
    double terms = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const TwoTerm left = p[i] * q[j], right = p[j] * q[i];
        volume = volume + d[k] * (left + -right);
        terms += std::abs(d[k].value) * (std::abs(left.value) + std::abs(right.value));
    }
    if (!is_in_range(terms)) return std::nullopt;
    const double error_bound = triple_product_error_bound * terms;
    if (tolerance * std::abs(volume.value) > error_bound) return volume.value;
    if (!keep_all_bits(least_term(d) * least_term(p) * least_term(q))) return std::nullopt;
    if (are_parallel(d, p) || are_parallel(d, q)) return 0;
    return exact_triple_product(d, p, q);
}

bool precedes(const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

constexpr double value_tolerance = 0x1p-38, sign_tolerance = 0.5;
constexpr double least_volume = 0x1p-900;  // its product with a direction is not 0

double edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b, double tolerance) {
    // Products of non-finite numbers could leave no terms at all, and so a zero.
    for (const Vec3& v : {o, d, a, b}) {
        if (!is_finite(v)) return nan_value;
    }
    // The estimate's last bit depends on the order of the terms: take one order for both.
    if (precedes(b, a)) return -edge_volume(o, d, b, a, tolerance);
    if (const auto volume =
            triple_product(two_terms(d), two_differences(a, o), two_differences(b, o), tolerance)) {
        return *volume;
    }
    const DyadicVec across = cross(difference(a, o), difference(b, o));
    return finite(dot(exactly(d), across), least_volume);
}

}  // namespace

double exact_edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b) {
    return edge_volume(o, d, a, b, value_tolerance);
}

double exact_edge_sign(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b) {
    return edge_volume(o, d, a, b, sign_tolerance);
}

double exact_volume(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::optional<double> volume = triple_product(
        two_differences(a, o), two_differences(b, o), two_differences(c, o), value_tolerance);
    return volume.value_or(nan_value);
}

double exact_dot(const Vec3& n, const Vec3& d) {
    return exact_dot(n, d, Vec3(0));
}

double exact_dot(const Vec3& n, const Vec3& p, const Vec3& o) {
    const Vec3TwoTerm d = two_differences(p, o);
    const std::array<TwoTerm, 3> term = {d[0] * TwoTerm{n.x, 0}, d[1] * TwoTerm{n.y, 0},
                                         d[2] * TwoTerm{n.z, 0}};
    const double sum = (term[0] + (term[1] + term[2])).value;
    const double terms =
        std::abs(term[0].value) + std::abs(term[1].value) + std::abs(term[2].value);
    const bool in_range = is_in_range(terms);
    if (in_range && std::abs(sum) > 0x1p-45 * terms) return sum;
    if (!in_range || !keep_all_bits(least_term(two_terms(n)) * least_term(d))) {
        if (!is_finite(n) || !is_finite(p) || !is_finite(o)) return nan_value;
        return finite(dot(exactly(n), difference(p, o)));
    }
    const auto exact = [](double x, const TwoTerm& y) { return Expansion<1>(x) * Difference(y); };
    return (exact(n.x, d[0]) + exact(n.y, d[1]) + exact(n.z, d[2])).estimate();
}

double exact_shear(double x, double a, double b, double y, double c, double e) {
    if ((x == 0 || a == b) && (y == 0 || c == e)) return 0;
    const TwoTerm left = two_difference(a, b), right = two_difference(c, e);
    const double least_left = least_term(TwoTerm{x, 0}) * least_term(left),
                 least_right = least_term(TwoTerm{y, 0}) * least_term(right);
    if (!is_in_range(std::abs(x * left.value) + std::abs(y * right.value)) ||
        !keep_all_bits(std::min(least_left, least_right))) {
        if (!are_finite(x, a, b, y, c, e)) return nan_value;
        return finite(Dyadic(x) * (Dyadic(a) - Dyadic(b)) - Dyadic(y) * (Dyadic(c) - Dyadic(e)));
    }
    return (Expansion<1>(x) * Difference(left) - Expansion<1>(y) * Difference(right)).estimate();
}

}  // namespace etalon
