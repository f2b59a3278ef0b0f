#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// A pinhole or thin-lens camera. Pixels are square; the view plane passes through `at`.
struct Camera {
    Vec3 eye, at, up;
    double fov_degrees = 45;  ///< full vertical field of view
    int width = 0, height = 0;
    double aperture = 0;  ///< lens diameter in pixels of the view plane; 0 is a pinhole
    double focal = 1;     ///< distance of the plane in focus, in units of |at - eye|
};

}  // namespace etalon
