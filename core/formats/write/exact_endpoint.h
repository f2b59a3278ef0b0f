// Points for the edges and planes of P3F. A reader of such a file takes their differences, which
// are, to the last bit, what a scene holds.
#pragma once

#include <array>

#include "core/scene/shapes.h"

namespace etalon {

/// A point, and whether it gives exactly what was asked for or only the nearest there is.
struct ExactEndpoint {
    Vec3 point;
    bool exact;
};

/// The point for which point - start is `edge`, as a reader computes it.
ExactEndpoint exact_endpoint(const Vec3& start, const Vec3& edge);

struct PlanePoints {
    std::array<Vec3, 3> points;
    bool exact;
};

/// Three points from which the reader makes this plane, its normal up to a power of two.
PlanePoints points_on(const Plane& plane);

}  // namespace etalon
