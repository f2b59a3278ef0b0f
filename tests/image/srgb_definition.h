#pragma once

#include <cmath>

namespace etalon::test {

/// Decodes sRGB by the definition in IEC 61966-2-1.
inline double linear_of(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace etalon::test
