#include "core/intersect/group_kernels.h"

#include <bit>

#include "core/intersect/kernels.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/group_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/intersect/shapes/box_lanes-inl.h"
#include "core/intersect/shapes/plane_lanes-inl.h"
#include "core/intersect/shapes/sphere_lanes-inl.h"
#include "core/intersect/shapes/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Asks primitive_first_hit() of the rays, from number `first` on, for which it is to say.
HWY_NOINLINE Doubles decide(const Geometry& geometry, std::uint32_t primitive, const HitLanes& hits,
                            const RayGroup& group, std::size_t first) {
    HWY_ALIGN double ts[most_doubles];
    hn::Store(hits.t, DoubleTag(), ts);
    std::uint8_t bits = 0;
    hn::StoreMaskBits(DoubleTag(), hits.doubtful, &bits);
    for (std::uint32_t left = bits; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        ts[lane] = primitive_first_hit(geometry, primitive, RayQuery(*group.rays[first + lane]));
    }
    return hn::Load(DoubleTag(), ts);
}

/// Offers `hits` to the rays from number `first` on: see NearestHit. Returns whether any was hit.
HWY_INLINE bool offer_lanes(const Geometry& geometry, std::uint32_t primitive, HitLanes hits,
                            RayGroup& group, std::size_t first) {
    const DoubleTag tag;
    const Doubles number = broadcast(primitive);
    const DoubleMask is_excluded = hn::LoadU(tag, &group.excludes[first]) == number;
    const DoubleMask is_tested = hn::AndNot(is_excluded, hn::FirstN(tag, group.count - first));
    hits.doubtful = hn::And(is_tested, hits.doubtful);
    if (HWY_UNLIKELY(!hn::AllFalse(tag, hits.doubtful))) {
        hits.t = decide(geometry, primitive, hits, group, first);
    }
    const Doubles t = hits.t, nearest = hn::LoadU(tag, &group.ts[first]);
    const Doubles holder = hn::LoadU(tag, &group.primitives[first]);
    const DoubleMask wins_tie =
        hn::And(t == nearest, hn::And(number < holder, t < broadcast(infinity)));
    const DoubleMask is_hit = hn::And(is_tested, hn::Or(t < nearest, wins_tie));
    if (hn::AllFalse(tag, is_hit)) return false;
    hn::StoreU(hn::IfThenElse(is_hit, t, nearest), tag, &group.ts[first]);
    hn::StoreU(hn::IfThenElse(is_hit, number, holder), tag, &group.primitives[first]);
    return true;
}

/// Offers a primitive, for which first_hits(rays) answers.
template <class FirstHits>
HWY_INLINE bool offer(const Geometry& geometry, std::uint32_t primitive, RayGroup& group,
                      const FirstHits& first_hits) {
    bool any = false;
    for (std::size_t i = 0; i < group.count; i += hn::Lanes(DoubleTag())) {
        any |= offer_lanes(geometry, primitive, first_hits(RayLanes(group, i)), group, i);
    }
    return any;
}

template <class Shape>
bool offer_shape(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    const Primitive p = geometry.primitives[primitive];
    const auto& shape = geometry.get<Shape>(p);
    return offer(geometry, primitive, group,
                 [&](const RayLanes& rays) HWY_ATTR { return first_hits(shape, p.sides, rays); });
}

template <int dominant>
bool offer_triangle_along(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    const Primitive p = geometry.primitives[primitive];
    const TriangleCorners corners(geometry, geometry.get<Triangle>(p));
    return offer(geometry, primitive, group, [&](const RayLanes& rays) HWY_ATTR {
        return first_hits<dominant>(corners, p.sides, rays);
    });
}

bool offer_triangle(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    if (group.dominant == 0) return offer_triangle_along<0>(geometry, primitive, group);
    if (group.dominant == 1) return offer_triangle_along<1>(geometry, primitive, group);
    return offer_triangle_along<2>(geometry, primitive, group);
}

bool offer_sphere(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    return offer_shape<Sphere>(geometry, primitive, group);
}
bool offer_box(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    return offer_shape<Box>(geometry, primitive, group);
}
bool offer_plane(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    return offer_shape<Plane>(geometry, primitive, group);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(offer_triangle);
HWY_EXPORT(offer_sphere);
HWY_EXPORT(offer_box);
HWY_EXPORT(offer_plane);

namespace {

bool offer_one_by_one(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    bool any = false;
    for (std::size_t i = 0; i < group.count; ++i) {
        const Hit before = group.hit(i);
        NearestHit nearest(before.t);
        nearest.item = before.primitive;
        nearest.offer(primitive_first_hit(geometry, primitive, RayQuery(*group.rays[i])),
                      primitive);
        if (nearest.item != primitive) continue;
        group.ts[i] = nearest.t;
        group.primitives[i] = primitive;
        any = true;
    }
    return any;
}

}  // namespace

bool has_group_kernel(const Primitive& p) {
    return p.sides != Sides::cut_out &&
           (p.kind == kind_of<Triangle>() || p.kind == kind_of<Sphere>() ||
            p.kind == kind_of<Box>() || p.kind == kind_of<Plane>());
}

bool offer_to_group(const Geometry& geometry, std::uint32_t primitive, RayGroup& group) {
    const Primitive p = geometry.primitives[primitive];
    if (!has_group_kernel(p)) return offer_one_by_one(geometry, primitive, group);
    switch (p.kind) {
        case kind_of<Triangle>():
            return HWY_DYNAMIC_DISPATCH(offer_triangle)(geometry, primitive, group);
        case kind_of<Sphere>():
            return HWY_DYNAMIC_DISPATCH(offer_sphere)(geometry, primitive, group);
        case kind_of<Box>():
            return HWY_DYNAMIC_DISPATCH(offer_box)(geometry, primitive, group);
        default:
            return HWY_DYNAMIC_DISPATCH(offer_plane)(geometry, primitive, group);
    }
}

}  // namespace etalon
#endif
