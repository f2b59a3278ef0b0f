#pragma once

#include "core/intersect/normalized_space.h"
#include "native_accel/grid/lanes.h"

namespace etalon {

/// A ray as grid traversal needs it: time per length and length per time along each axis, without
/// signs, which are stored separately.
struct GridRay {
    HWY_INLINE explicit GridRay(const NormalizedRay& ray) : origin(lanes(ray.origin, 0)) {
        // At least 2^-40 of the largest component. This avoids infinity times zero; over the few
        // units that a ray travels in normalized space it shifts the ray by far less than the
        // padding.
        const Float4 direction = lanes(ray.direction, 1);
        forward = direction >= 0;
        speed = max(abs(direction), broadcast(0x1p-40F));
        pace = keep(axes, 1 / speed);
        speed = keep(axes, speed);
        reciprocal = select(forward, pace, -pace);
    }

    static constexpr Mask4 axes{-1, -1, -1, 0};
    Float4 origin, speed, pace, reciprocal;
    Mask4 forward;
};

}  // namespace etalon
