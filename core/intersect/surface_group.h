#pragma once

#include "core/intersect/ray_stream.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Hits on one primitive and the output arrays for their points. At most as many as a word has
/// bits.
struct SurfaceGroup {
    static constexpr std::size_t most = 64;

    RayStream rays;
    const Hit* hits;  ///< one for each ray
    /// Numbers of the rays that hit the primitive, in increasing order; padded with any other
    /// numbers.
    const std::uint32_t* numbers;
    std::size_t count = 0;
    MutableVec3Span directions;                                   ///< of these rays; padded
    MutableVec3Span positions, errors, normals, shading_normals;  ///< of their points; padded
};

/// Returns whether there is a kernel for groups of hits on the primitive.
bool has_surface_group(const Geometry& geometry, const Primitive& primitive);

/// Sets the points of a group of hits on such a primitive, with the bits of surface_at(). `any` is
/// one of the points, found by surface_at(). Returns a bit for each point, the lowest bit first. A
/// point whose bit is 0 is not set and must be computed by surface_at().
std::uint64_t find_surfaces(const Geometry& geometry, const Primitive& primitive,
                            const SurfacePoint& any, const SurfaceGroup& group);

}  // namespace etalon
