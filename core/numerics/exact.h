// Signs that must be right: error-free transforms and a small expansion arithmetic.
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

/// value + error is the exact result; |error| <= ulp(value)/2.
struct TwoTerm {
    double value;
    double error;
};

/// Knuth's exact sum, no condition on the magnitudes.
inline TwoTerm two_sum(double a, double b) {
    const double s = a + b;
    const double bb = s - a;
    return {s, (a - (s - bb)) + (b - bb)};
}

inline TwoTerm two_difference(double a, double b) {
    return two_sum(a, -b);
}

/// Exact product by a fused multiply-add.
inline TwoTerm two_product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
}

/// A nonadjacent expansion, terms by increasing magnitude, without zeros. The capacity is part of
/// the type, as every operation knows how many terms it can make: nothing is ever allocated.
template <std::size_t Capacity>
class Expansion {
  public:
    Expansion() = default;
    explicit Expansion(double x) { add(x); }
    explicit Expansion(TwoTerm t) {
        add(t.error);
        add(t.value);
    }

    /// Grow-expansion with zero elimination (Shewchuk 1997, fig. 6).
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

    /// The nearest double, to within a few ulp, with the exact sign: no term touches a bit next to
    /// those of another, so the last one outweighs the rounded sum of all before it.
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

/// d . (p x q) for p = a - o and q = b - o: six times the signed volume that the direction d and
/// the edge (a, b) span seen from o. The sign is exact and the value good to 2^-38. Swapping a and
/// b gives exactly the negated value, which is what makes a shared edge watertight. What is beyond
/// the range of double, here and below, is the largest or smallest there is, but never 0.
double exact_edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b);

/// The exact sign, with a value that is off by 2^-100 of the terms of the sum; less slow.
double exact_edge_sign(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b);

/// (a - o) . ((b - o) x (c - o)): six times the signed volume of the tetrahedron. As good as that,
/// but NaN where its terms leave the range of double, or are all 0.
double exact_volume(const Vec3& o, const Vec3& a, const Vec3& b, const Vec3& c);

/// n . d, and n . (p - o), with the exact sign, and good to a few ulp; slow.
double exact_dot(const Vec3& n, const Vec3& d);
double exact_dot(const Vec3& n, const Vec3& p, const Vec3& o);

/// x (a - b) - y (c - e) with the exact sign, and good to a few ulp; slow.
double exact_shear(double x, double a, double b, double y, double c, double e);

/// The same, in plain double where its error bound shows the sign to be right: two roundings in
/// either product and one in their difference.
inline double shear_sign(double x, double a, double b, double y, double c, double e) {
    const double p = x * (a - b), q = y * (c - e);
    const double bound = 4 * unit_roundoff * (std::abs(p) + std::abs(q)) + 0x1p-1000;
    return std::abs(p - q) > bound ? p - q : exact_shear(x, a, b, y, c, e);
}

}  // namespace etalon
