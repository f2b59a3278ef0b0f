#include "core/intersect/packet_kernels.h"

#include <bit>
#include <optional>

#include "core/intersect/kernels.h"
#include "core/scene/projected_outline.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/packet_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/intersect/shapes/box_lanes-inl.h"
#include "core/intersect/shapes/cone_lanes-inl.h"
#include "core/intersect/shapes/plane_lanes-inl.h"
#include "core/intersect/shapes/polygon_lanes-inl.h"
#include "core/intersect/shapes/sphere_lanes-inl.h"
#include "core/intersect/shapes/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Replaces uncertain hits of the rays from number `first` on by those of primitive_first_hit().
HWY_NOINLINE Doubles decide(const Geometry& geometry, std::uint32_t primitive, const HitLanes& hits,
                            const RayPacket& packet, std::size_t first) {
    HWY_ALIGN double ts[most_doubles];
    hn::Store(hits.t, DoubleTag(), ts);
    std::uint8_t bits = 0;
    hn::StoreMaskBits(DoubleTag(), hits.uncertain, &bits);
    for (std::uint32_t left = bits; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        ts[lane] = primitive_first_hit(geometry, primitive, RayQuery(packet.ray(first + lane)));
    }
    return hn::Load(DoubleTag(), ts);
}

/// Offers `hits` to those rays from number `first` on that are tested: see NearestHit. Returns
/// whether any was hit.
HWY_INLINE bool offer_lanes(const Geometry& geometry, std::uint32_t primitive, HitLanes hits,
                            DoubleMask is_tested, RayPacket& packet, std::size_t first) {
    const DoubleTag tag;
    const Doubles number = broadcast(primitive);
    hits.uncertain = hn::And(is_tested, hits.uncertain);
    if (HWY_UNLIKELY(!hn::AllFalse(tag, hits.uncertain))) {
        hits.t = decide(geometry, primitive, hits, packet, first);
    }
    const Doubles t = hits.t, nearest = hn::LoadU(tag, &packet.ts[first]);
    const Doubles holder = hn::LoadU(tag, &packet.primitives[first]);
    const DoubleMask wins_tie =
        hn::And(t == nearest, hn::And(number < holder, t < broadcast(infinity)));
    const DoubleMask is_hit = hn::And(is_tested, hn::Or(t < nearest, wins_tie));
    if (hn::AllFalse(tag, is_hit)) return false;
    hn::StoreU(hn::IfThenElse(is_hit, t, nearest), tag, &packet.ts[first]);
    hn::StoreU(hn::IfThenElse(is_hit, number, holder), tag, &packet.primitives[first]);
    return true;
}

/// Offers a primitive whose hits first_hits(rays) returns. Rays that exclude it, such as those that
/// leave it, are mostly neighbours.
template <class FirstHits>
HWY_INLINE bool offer(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet,
                      const FirstHits& first_hits) {
    const DoubleTag tag;
    const Doubles number = broadcast(primitive);
    bool any = false;
    for (std::size_t i = 0; i < packet.count; i += hn::Lanes(tag)) {
        const DoubleMask is_excluded = hn::LoadU(tag, &packet.excludes[i]) == number;
        const DoubleMask is_tested = hn::AndNot(is_excluded, hn::FirstN(tag, packet.count - i));
        if (hn::AllFalse(tag, is_tested)) continue;
        const HitLanes hits = first_hits(RayLanes(packet, i));
        any |= offer_lanes(geometry, primitive, hits, is_tested, packet, i);
    }
    return any;
}

template <class Shape>
bool offer_shape(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    const Primitive p = geometry.primitives[primitive];
    const auto& shape = geometry.get<Shape>(p);
    return offer(geometry, primitive, packet,
                 [&](const RayLanes& rays) HWY_ATTR { return first_hits(shape, p.sides, rays); });
}

template <int dominant>
bool offer_triangle_along(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    const Primitive p = geometry.primitives[primitive];
    const TriangleCorners corners(geometry, geometry.get<Triangle>(p));
    return offer(geometry, primitive, packet, [&](const RayLanes& rays) HWY_ATTR {
        return first_hits<dominant>(corners, p.sides, rays);
    });
}

bool offer_triangle(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    if (packet.dominant == 0) return offer_triangle_along<0>(geometry, primitive, packet);
    if (packet.dominant == 1) return offer_triangle_along<1>(geometry, primitive, packet);
    return offer_triangle_along<2>(geometry, primitive, packet);
}

bool offer_sphere(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    return offer_shape<Sphere>(geometry, primitive, packet);
}
bool offer_box(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    return offer_shape<Box>(geometry, primitive, packet);
}
bool offer_plane(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    return offer_shape<Plane>(geometry, primitive, packet);
}
bool offer_cone(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    return offer_shape<Cone>(geometry, primitive, packet);
}
bool offer_polygon(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    const Primitive p = geometry.primitives[primitive];
    const StoredPolygon polygon = geometry.get<Polygon>(p);
    std::optional<SmallOutline> small;
    if (polygon.columns.edges == 0) small.emplace(polygon);
    const OutlineColumns columns = small ? small->columns() : polygon.columns;
    return offer(geometry, primitive, packet, [&](const RayLanes& rays) HWY_ATTR {
        return first_hits(polygon, columns, p.sides, rays);
    });
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(offer_triangle);
HWY_EXPORT(offer_sphere);
HWY_EXPORT(offer_box);
HWY_EXPORT(offer_plane);
HWY_EXPORT(offer_cone);
HWY_EXPORT(offer_polygon);

namespace {

bool offer_one_by_one(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    bool any = false;
    for (std::size_t i = 0; i < packet.count; ++i) {
        if (packet.excludes[i] == primitive) continue;
        const Hit before = packet.hit(i);
        NearestHit nearest(before.t);
        nearest.item = before.primitive;
        nearest.offer(primitive_first_hit(geometry, primitive, RayQuery(packet.ray(i))), primitive);
        if (nearest.item != primitive) continue;
        packet.ts[i] = nearest.t;
        packet.primitives[i] = primitive;
        any = true;
    }
    return any;
}

}  // namespace

bool has_packet_kernel(const Primitive& p) {
    if (p.sides == Sides::cut_out) return false;
    return p.kind == kind_of<Triangle>() || p.kind == kind_of<Sphere>() ||
           p.kind == kind_of<Box>() || p.kind == kind_of<Cone>() || p.kind == kind_of<Polygon>() ||
           p.kind == kind_of<Plane>();
}

bool offer_to_packet(const Geometry& geometry, std::uint32_t primitive, RayPacket& packet) {
    const Primitive p = geometry.primitives[primitive];
    if (!has_packet_kernel(p)) return offer_one_by_one(geometry, primitive, packet);
    switch (p.kind) {
        case kind_of<Triangle>():
            return HWY_DYNAMIC_DISPATCH(offer_triangle)(geometry, primitive, packet);
        case kind_of<Sphere>():
            return HWY_DYNAMIC_DISPATCH(offer_sphere)(geometry, primitive, packet);
        case kind_of<Box>():
            return HWY_DYNAMIC_DISPATCH(offer_box)(geometry, primitive, packet);
        case kind_of<Cone>():
            return HWY_DYNAMIC_DISPATCH(offer_cone)(geometry, primitive, packet);
        case kind_of<Polygon>():
            return HWY_DYNAMIC_DISPATCH(offer_polygon)(geometry, primitive, packet);
        default:
            return HWY_DYNAMIC_DISPATCH(offer_plane)(geometry, primitive, packet);
    }
}

}  // namespace etalon
#endif
