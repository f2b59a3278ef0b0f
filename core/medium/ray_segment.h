#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numerics/vec.h"

namespace etalon {

/// The part of a ray that lies in one medium.
struct RaySegment {
    Vec3 origin, direction;  ///< direction of unit length
    double length;           ///< infinity if the medium has no end

    Vec3 point(double distance) const { return origin + distance * direction; }
};

/// Sampled point at which a ray in a medium is scattered, if it is.
struct FreeFlight {
    double distance;    ///< from the segment's origin; infinity: not within the segment
    Color weight;       ///< factor of the path's throughput
    float density = 0;  ///< density of `distance` per unit of length; 0 if it is not known

    bool scatters() const { return distance < infinity; }
};

/// Fractions of a ray's light that a medium lets pass and scatters.
struct DividedLight {
    Color passing, scattered;
};

/// Returns the fraction of light that is left after `length` in a medium of that extinction (Beer
/// and Lambert).
inline Color transmittance(const Color& extinction, double length) {
    const double finite = std::min(length, std::numeric_limits<double>::max());
    Color result(static_cast<float>(std::exp(-extinction.x * finite)));
    for (int c = 1; c < 3; ++c) {  // most media are grey
        if (extinction[c] == extinction.x) continue;
        result[c] = static_cast<float>(std::exp(-extinction[c] * finite));
    }
    return result;
}

/// Returns the distance of the next collision in units of the mean free path, for u in [0, 1).
inline double optical_distance(double u) {
    return -std::log1p(-u);
}

}  // namespace etalon
