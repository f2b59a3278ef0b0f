#pragma once

#include "core/intersect/frame.h"
#include "native_accel/grid/lanes.h"

namespace etalon {

/// A ray as the walk through grids wants it: time per length and length per time along each axis,
/// without signs, which are apart.
struct GridRay {
    explicit GridRay(const FrameRay& ray) {
        for (int k = 0; k < 3; ++k) {
            // No smaller than 2^-40 of the largest component: no infinity times zero, and over the
            // few units a ray can travel in the frame a drift far below the padding.
            const float d = ray.direction[k];
            const float clamped = std::abs(d) < 0x1p-40F ? std::copysign(0x1p-40F, d) : d;
            origin[k] = ray.origin[k];
            speed[k] = std::abs(clamped);
            reciprocal[k] = 1.0F / clamped;
            forward[k] = clamped > 0 ? -1 : 0;
        }
        pace = abs(reciprocal);
    }

    Float4 origin{}, speed{}, reciprocal{}, pace{};
    Mask4 forward{0, 0, 0, -1};
};

}  // namespace etalon
