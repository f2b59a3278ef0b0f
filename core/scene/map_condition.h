#pragma once

#include <algorithm>
#include <array>

#include "core/numerics/affine.h"

namespace etalon {

/// Returns how much a map and its inverse amplify the roundings of a point that is transformed by
/// both: the largest row sum of |M| |R|, where M is the map's matrix and R its inverse. The lengths
/// of the axes do not matter, only how far they lean towards each other.
inline double condition_of(const Affine& map, const std::array<Vec3, 3>& inverse) {
    Vec3 sums(0);
    for (int k = 0; k < 3; ++k) {
        const double of_x = std::abs(inverse[0][k]), of_y = std::abs(inverse[1][k]),
                     of_z = std::abs(inverse[2][k]);
        sums += of_x * abs(map.x) + of_y * abs(map.y) + of_z * abs(map.z);
    }
    return max_abs(sums);
}

/// Returns the largest ratio of the lengths of a map's axes. Roundings in the space of its inverse
/// grow by that factor if they are rotated there from a short axis into a long one.
inline double stretch_of(const Affine& map, const std::array<Vec3, 3>& inverse) {
    const auto largest = [](const Vec3& a, const Vec3& b, const Vec3& c) {
        return std::max(std::max(max_abs(a), max_abs(b)), max_abs(c));
    };
    return largest(map.x, map.y, map.z) * largest(inverse[0], inverse[1], inverse[2]);
}

}  // namespace etalon
