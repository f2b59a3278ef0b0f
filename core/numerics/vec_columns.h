#pragma once

#include <array>
#include <cstddef>

#include "core/numerics/vec.h"

namespace etalon {

/// Vectors with their components apart, as vector instructions load them without shuffling.
template <std::size_t most>
struct Vec3Columns {
    void set(std::size_t i, const Vec3& v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }

    std::array<double, most> x, y, z;
};

}  // namespace etalon
