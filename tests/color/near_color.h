#pragma once

#include "core/numerics/vec.h"
#include "tests/catch.h"

namespace etalon {

/// Returns whether each component of a colour is within `error`, relative to the largest component,
/// of the expected one.
inline bool is_near(const Color& color, const Color& expected, double error) {
    const auto size = std::max({std::abs(expected.x), std::abs(expected.y), std::abs(expected.z)});
    const Color d = color - expected;
    CAPTURE(color.x, color.y, color.z);
    const bool near = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) <= error * size;
    CHECK(near);
    return near;
}

}  // namespace etalon
