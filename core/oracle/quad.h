// IEEE binary128: 113 bits, and an exponent that products of doubles do not overflow.
#pragma once

#include <cmath>
#include <limits>

namespace etalon {

#if __LDBL_MANT_DIG__ == 113
using Quad = long double;
#else
__extension__ typedef __float128 Quad;
#endif

/// Unit roundoff of Quad.
inline constexpr Quad quad_roundoff = Quad(0x1p-113);

inline Quad magnitude(Quad x) {
    return x < 0 ? -x : x;
}

/// Returns the square root to within one unit in the last place; x > 0.
inline Quad square_root(Quad x) {
    Quad scale = 1;
    while (x > Quad(0x1p900)) x *= Quad(0x1p-800), scale *= Quad(0x1p400);
    while (x < Quad(0x1p-900)) x *= Quad(0x1p800), scale *= Quad(0x1p-400);
    Quad root = std::sqrt(static_cast<double>(x));
    for (int step = 0; step < 2; ++step) root = (root + x / root) / 2;  // 53 bits, 105, all
    return root * scale;
}

}  // namespace etalon
