// Exact signs: error-free transforms and a small expansion arithmetic.
//
// An expansion is an unevaluated sum of doubles whose exact value is that sum
// (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates"). It is slow and only for the few decisions that a floating-point filter cannot take.
// Everything here is exact unless a product leaves the range of double.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/numerics/rounding.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Exact result as value + error, with |error| <= ulp(value)/2.
struct TwoTerm {
    double value;
    double error;
};

/// Returns Knuth's exact sum; the magnitudes need no order.
inline TwoTerm two_sum(double a, double b) {
    const double s = a + b;
    const double bb = s - a;
    return {s, (a - (s - bb)) + (b - bb)};
}

inline TwoTerm two_difference(double a, double b) {
    return two_sum(a, -b);
}

/// Returns the exact product, by a fused multiply-add.
inline TwoTerm two_product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
}

/// A nonadjacent expansion: terms by increasing magnitude, without zeros. The capacity is part of
/// the type, since every operation knows how many terms it can make: nothing is ever allocated.
template <std::size_t Capacity>
class Expansion {
  public:
    Expansion() = default;
    explicit Expansion(double x) { add(x); }
    explicit Expansion(TwoTerm t) {
        add(t.error);
        add(t.value);
    }

    /// Adds a term by grow-expansion with zero elimination (Shewchuk 1997, fig. 6).
    void add(double x) {
        std::size_t kept = 0;
        for (const double term : *this) {
            const TwoTerm s = two_sum(x, term);
            if (s.error != 0) terms_[kept++] = s.error;
            x = s.value;
        }
        if (x != 0) terms_[kept++] = x;
        size_ = kept;
    }

    /// Returns the nearest double, to within a few ulp, with the exact sign. The terms are
    /// nonadjacent, so the last one outweighs the rounded sum of all before it.
    double estimate() const {
        double sum = 0;
        for (const double term : *this) sum += term;
        return sum;
    }

    const double* begin() const { return terms_.data(); }
    const double* end() const { return terms_.data() + size_; }

  private:
    std::array<double, Capacity> terms_;
    std::size_t size_ = 0;
};

template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
    Expansion<N + M> sum;
    for (const double term : a) sum.add(term);
    for (const double term : b) sum.add(term);
    return sum;
}

template <std::size_t N, std::size_t M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
    Expansion<N + M> difference;
    for (const double term : a) difference.add(term);
    for (const double term : b) difference.add(-term);
    return difference;
}

template <std::size_t N, std::size_t M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
    Expansion<2 * N * M> product;
    for (const double x : a) {
        for (const double y : b) {
            const TwoTerm p = two_product(x, y);
            product.add(p.error);
            product.add(p.value);
        }
    }
    return product;
}

/// Returns d . (p x q) for p = a - o and q = b - o: six times the signed volume that the direction
/// d and the edge (a, b) span, seen from o. The sign is exact and the value good to 2^-38. Swapping
/// a and b gives exactly the negated value, which makes shared edges watertight. Values beyond the
/// range of double, here and below, become the largest or smallest double, but never 0.
double exact_edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b);

/// The same with the exact sign and an error of at most 2^-100 of the sum's terms; less slow.
double exact_edge_sign(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b);

/// Returns (a - o) . ((b - o) x (c - o)), six times the signed volume of the tetrahedron, with the
/// exact sign and good to 2^-38; NaN if its terms leave the range of double, or are all 0.
double exact_volume(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c);

/// Return n . d and n . (p - o), with the exact sign and good to a few ulp; slow.
double exact_dot(const Vec3& n, const Vec3& d);
double exact_dot(const Vec3& n, const Vec3& p, const Vec3& o);

/// Returns x (a - b) - y (c - e), with the exact sign and good to a few ulp; slow.
double exact_shear(double x, double a, double b, double y, double c, double e);

/// The same, in plain double if its error bound proves the sign: two roundings in either product
/// and one in their difference.
inline double shear_sign(double x, double a, double b, double y, double c, double e) {
    const double p = x * (a - b), q = y * (c - e);
    const double bound = 4 * unit_roundoff * (std::abs(p) + std::abs(q)) + 0x1p-1000;
    return std::abs(p - q) > bound ? p - q : exact_shear(x, a, b, y, c, e);
}

}  // namespace etalon
