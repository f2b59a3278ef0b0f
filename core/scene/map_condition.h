#pragma once

#include <array>

#include "core/numerics/affine.h"

namespace etalon {

/// How many times larger than those of its own numbers the roundings of a point can be that is
/// taken through the inverse of a map and back: the largest sum of a row of |M| |R|, M the map's
/// matrix, R its inverse of these rows. Lengths of the axes do not count, only how far they lean
/// towards each other.
inline double condition_of(const Affine& map, const std::array<Vec3, 3>& inverse) {
    Vec3 sums(0);
    for (int k = 0; k < 3; ++k) {
        const double of_x = std::abs(inverse[0][k]), of_y = std::abs(inverse[1][k]),
                     of_z = std::abs(inverse[2][k]);
        sums += of_x * abs(map.x) + of_y * abs(map.y) + of_z * abs(map.z);
    }
    return max_abs(sums);
}

}  // namespace etalon
