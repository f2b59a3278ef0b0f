#pragma once

#include "core/integrators/path/path_vertices.h"

namespace etalon {

/// Returns the density with which a vertex samples a direction for which its scattering alone has
/// `own`.
template <bool in_media, class Vertex>
float density_of(const Vertex& at, const Vec3& wi, float own) {
    if (!in_media || !at.lit_regions) return own;
    const float part = at.lit_regions->part();
    return (1 - part) * own + (at.reflects(wi) ? part * at.lit_regions->density(wi) : 0);
}

}  // namespace etalon
