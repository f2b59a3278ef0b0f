// Signs that must be right: error-free transforms and a small expansion arithmetic.
//
// An expansion is an unevaluated sum of doubles whose exact value is that sum
// (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates"). It is slow and only for the few decisions that a floating-point filter cannot take.
// Everything here is exact unless a product leaves the range of double.
#pragma once

#include <cmath>
#include <vector>

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

inline TwoTerm two_difference(double a, double b) { return two_sum(a, -b); }

/// Exact product by a fused multiply-add.
inline TwoTerm two_product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
}

/// A nonoverlapping expansion, terms by increasing magnitude, without zeros.
class Expansion {
  public:
    Expansion() = default;
    explicit Expansion(TwoTerm t);

    void add(double x);
    Expansion& operator+=(const Expansion& other);
    Expansion operator*(const Expansion& other) const;
    Expansion operator-() const;

    /// The nearest double, to within a few ulp, with the exact sign.
    double estimate() const;

  private:
    std::vector<double> terms_;
};

/// d . (p x q) for p = a - o and q = b - o: six times the signed volume that the direction d and the
/// edge (a, b) span seen from o. The sign is exact and the value good to a few ulp.
/// Swapping a and b gives exactly the negated value, which is what makes a shared edge watertight.
double exact_edge_volume(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b);

}  // namespace etalon
