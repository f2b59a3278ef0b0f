#pragma once

#include <bit>

#include "core/intersect/normalized_space.h"
#include "embree_backend/embree_shim.h"

namespace etalon {

/// Fills in Embree's ray. It is written as the three vectors that Embree reads, because a vector
/// load cannot be forwarded from pending scalar stores.
inline void set_ray(RTCRay& to, const NormalizedRay& from, float tnear, float tfar) {
    using Row = float __attribute__((vector_size(16), may_alias));
    const float every_mask = std::bit_cast<float>(0xFFFFFFFFU);
    const Vec3f& o = from.origin;
    const Vec3f& d = from.direction;
    Row* rows = reinterpret_cast<Row*>(&to);
    rows[0] = Row{o.x, o.y, o.z, tnear};
    rows[1] = Row{d.x, d.y, d.z, 0};
    rows[2] = Row{tfar, every_mask, 0, 0};
}

/// Fills in Embree's ray for an occlusion query. Returns false if it ends before 0, where nothing
/// is hit: Embree reports a hit by a negative tfar.
inline bool set_occlusion_ray(RTCRay& to, const NormalizedRay& from, float tnear, float tfar) {
    if (tfar < 0) return false;
    set_ray(to, from, tnear, tfar);
    return true;
}

}  // namespace etalon
