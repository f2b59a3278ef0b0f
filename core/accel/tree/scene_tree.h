#pragma once

#include "core/accel/tree/builder.h"
#include "core/intersect/normalized_space.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Builds a scene's tree. It is built over pieces of triangles (presplit.h) where that makes it
/// much cheaper, so that a primitive may be in several leaves.
BvhTree build_scene_bvh(const Geometry& geometry, const NormalizedSpace& space,
                        std::vector<BoundedPrimitive> primitives, const BvhConfig& config = {});

}  // namespace etalon
