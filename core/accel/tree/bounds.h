// Boxes for building: four floats for each corner, the fourth of which is unused.
#pragma once

#include <cstring>
#include <limits>

#include "core/intersect/bounded.h"

namespace etalon {

struct Bounds {
    using Corner = float __attribute__((vector_size(16)));

    static Corner corner(float x) { return Corner{x, x, x, 0}; }
    static Corner lower(Corner a, Corner b) { return a < b ? a : b; }
    static Corner upper(Corner a, Corner b) { return a > b ? a : b; }

    static Bounds of(const BoundedPrimitive& p) {
        const auto* bytes = reinterpret_cast<const char*>(&p);
        Bounds b;
        std::memcpy(&b.min, bytes, sizeof(b.min));
        std::memcpy(&b.max, bytes + sizeof(b.min), sizeof(b.max));
        return b;
    }

    void extend(const Bounds& other) {
        min = lower(min, other.min);
        max = upper(max, other.max);
    }
    void extend(Corner point) {
        min = lower(min, point);
        max = upper(max, point);
    }

    /// Returns half the surface area. The box must not be empty.
    float half_area() const {
        const Corner s = max - min;
        return s[0] * (s[1] + s[2]) + s[1] * s[2];
    }

    Box3f box() const { return {Vec3f(min[0], min[1], min[2]), Vec3f(max[0], max[1], max[2])}; }

    Corner min = corner(std::numeric_limits<float>::infinity());
    Corner max = corner(-std::numeric_limits<float>::infinity());
};

/// Returns twice the centre of a box. The fourth component, unused in the corners, is cleared.
inline Bounds::Corner twice_centre(const Bounds& b) {
    using Bits = std::int32_t __attribute__((vector_size(16)));
    return reinterpret_cast<Bounds::Corner>(reinterpret_cast<Bits>(b.min + b.max) &
                                            Bits{-1, -1, -1, 0});
}

}  // namespace etalon
