#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// A pinhole or thin-lens camera. The view plane passes through `at`.
struct Camera {
    Vec3 eye, at, up;
    double fov_degrees = 45;  ///< full vertical field of view
    double aperture = 0;      ///< lens diameter in pixel heights on the view plane; 0 is a pinhole
    double focal = 1;         ///< distance of the plane in focus, in units of |at - eye|
    bool stretched = false;   ///< the field of view is the horizontal one, too: pixels need not be
                              ///< square, as otherwise they are
};

}  // namespace etalon
