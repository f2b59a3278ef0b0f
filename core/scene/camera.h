#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Where a picture without samples (spp 0) has its rays.
enum class PixelRays : std::uint8_t {
    centre,         ///< one through each pixel's centre
    upper_left,     ///< one through each pixel's upper left corner
    shared_corners  ///< one through each corner, which counts for all the pixels about it
};

/// A pinhole or thin-lens camera. The view plane passes through `at`.
struct Camera {
    Vec3 eye, at, up;
    double fov_degrees = 45;  ///< full vertical field of view
    int width = 0, height = 0;
    double aperture = 0;     ///< lens diameter in pixel heights on the view plane; 0 is a pinhole
    double focal = 1;        ///< distance of the plane in focus, in units of |at - eye|
    bool stretched = false;  ///< the field of view is the horizontal one, too: pixels need not be
                             ///< square, as otherwise they are
    PixelRays pixel_rays = PixelRays::centre;
};

}  // namespace etalon
