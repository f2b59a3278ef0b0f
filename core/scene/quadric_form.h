// The quadratic form that vanishes on a quadric, for any number type.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace etalon {

/// Returns coefficients of a form that bounds the sum of the magnitudes of another form's terms.
inline std::array<double, 10> magnitudes_of(std::array<double, 10> coefficients) {
    std::transform(coefficients.begin(), coefficients.end(), coefficients.begin(),
                   [](double x) { return std::abs(x); });
    return coefficients;
}

/// Returns coefficients of the same surface, scaled by `factor` about its centre.
inline std::array<double, 10> scaled(std::array<double, 10> coefficients, double factor) {
    for (const std::size_t linear : {3U, 6U, 8U}) coefficients[linear] *= factor;
    coefficients[9] *= factor * factor;
    return coefficients;
}

/// Values of the form: v.Mv + 2 l.v + j at a point v, and A t^2 + 2 B t + C on the line w + t d.
template <class Number, class Vector>
struct QuadricLine {
    Vector Md;
    Vector slope;  ///< Mw + l: half the gradient at w
    Number A, B, C;
};

template <class Number>
class QuadricForm {
  public:
    explicit QuadricForm(const std::array<Number, 10>& coefficients) : c_(coefficients) {}

    template <class Vector>
    QuadricLine<Number, Vector> on_line(const Vector& w, const Vector& d) const {
        const Vector l{c_[3], c_[6], c_[8]}, Md = times_matrix(d), slope = times_matrix(w) + l;
        return {Md, slope, sum(d, Md), sum(d, slope), sum(w, slope + l) + c_[9]};
    }

    template <class Vector>
    Vector times_matrix(const Vector& v) const {
        return Vector{c_[0] * v[0] + c_[1] * v[1] + c_[2] * v[2],
                      c_[1] * v[0] + c_[4] * v[1] + c_[5] * v[2],
                      c_[2] * v[0] + c_[5] * v[1] + c_[7] * v[2]};
    }

  private:
    template <class Vector>
    static Number sum(const Vector& a, const Vector& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    std::array<Number, 10> c_;
};

}  // namespace etalon
