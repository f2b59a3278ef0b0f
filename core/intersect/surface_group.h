#pragma once

#include <array>

#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Hits on one primitive, side by side, and where their points go: so many that they stay in the
/// fastest cache.
struct SurfaceGroup {
    static constexpr std::size_t most = 64;

    std::size_t count = 0;
    std::array<Vec3, most> origins;  ///< of the rays
    std::array<double, most> ts;
    const Vec3* directions;                                ///< of the rays; padded
    Vec3 *positions, *errors, *normals, *shading_normals;  ///< of the points; padded
};

/// Whether there is a kernel for groups of hits on the primitive.
bool has_surface_group(const Primitive& primitive);

/// Sets the points of a group of hits on such a primitive: to the bits of surface_at(), which has
/// found one of them, `any`. Returns a bit for each point, from the lowest on; where it is not set,
/// surface_at() is to be asked.
std::uint64_t find_surfaces(const Geometry& geometry, const Primitive& primitive,
                            const SurfacePoint& any, const SurfaceGroup& group);

}  // namespace etalon
