#pragma once

#include "core/integrators/path/lit_regions.h"

namespace etalon {

/// Lit spheres as seen from a point: cones of directions, in SoA layout. A cone is given by 1 - cos
/// of its half angle, which is half the largest squared distance between the ends of its unit
/// vectors and of its axis.
struct LitSpheresFrom {
    static constexpr std::size_t count = LitSpheres::count;

    LitSpheresFrom(const LitSpheres& spheres, const Receiver& at);

    /// Sets the densities of directions to the spheres, of which each gets its weight's part of
    /// `sum`.
    void share(float sum);

    /// Returns the sum of the densities of the cones that a unit vector is in.
    float density(const Vec3& direction) const;

    std::array<float, count> x, y, z;  ///< axes
    std::array<float, count> sagitta;  ///< 1 - cos; 2 for all directions
    std::array<float, count> weights;  ///< 0 for what is not visible
    std::array<float, count> densities;
};

}  // namespace etalon
