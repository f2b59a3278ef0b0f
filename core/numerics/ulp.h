// Units in the last place, in which errors are reported.
#pragma once

#include <cmath>
#include <limits>

namespace etalon {

/// Returns the distance of |x| from the next larger double.
inline double ulp_of_double(double x) {
    return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

/// Returns the spacing of floats at x, as if their exponent were unbounded; 0 for 0.
inline double ulp_of_float(double x) {
    return x == 0 ? 0 : std::ldexp(1.0, std::ilogb(x) - 23);
}

}  // namespace etalon
