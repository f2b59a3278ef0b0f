// Points for the edges and planes of P3F. A reader of the file subtracts them, which gives the
// scene's edges and planes to the last bit.
#pragma once

#include <array>

#include "core/scene/shapes.h"

namespace etalon {

/// A point, and whether it gives the result exactly or only as nearly as possible.
struct ExactEndpoint {
    Vec3 point;
    bool exact;
};

/// Returns the point for which point - start is `edge`, as a reader computes it.
ExactEndpoint exact_endpoint(const Vec3& start, const Vec3& edge);

struct PlanePoints {
    std::array<Vec3, 3> points;
    bool exact;
};

/// Returns three points from which a reader makes this plane, with its normal up to a power of two.
PlanePoints points_on(const Plane& plane);

}  // namespace etalon
