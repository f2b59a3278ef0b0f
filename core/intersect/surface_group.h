#pragma once

#include "core/intersect/ray_stream.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Hits on one primitive, and where their points go: at most as many as a word has bits.
struct SurfaceGroup {
    static constexpr std::size_t most = 64;

    RayStream rays;
    const Hit* hits;  ///< one for each ray
    /// Of the rays that hit the primitive, the least first; padded with those of any others.
    const std::uint32_t* numbers;
    std::size_t count = 0;
    MutableVec3Span directions;                                   ///< of these rays; padded
    MutableVec3Span positions, errors, normals, shading_normals;  ///< of the points; padded
};

/// Returns whether there is a kernel for groups of hits on the primitive.
bool has_surface_group(const Primitive& primitive);

/// Sets the points of a group of hits on such a primitive: to the bits of surface_at(), which has
/// found one of them, `any`. Returns a bit for each point, from the lowest on; where it is not set,
/// surface_at() is to be asked.
std::uint64_t find_surfaces(const Geometry& geometry, const Primitive& primitive,
                            const SurfacePoint& any, const SurfaceGroup& group);

}  // namespace etalon
