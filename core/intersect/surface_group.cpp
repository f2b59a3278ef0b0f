#include "core/intersect/surface_group.h"

#include <algorithm>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/surface_group.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/intersect/shapes/surface_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Returns whether RayQuery leaves a component of the direction as it is.
HWY_INLINE DoubleMask is_kept(Doubles size, Doubles least) {
    return hn::Or(size >= least, size == broadcast(0));
}

HWY_INLINE DoubleMask is_kept(const Vec3Lanes& direction) {
    const Vec3Lanes size = abs(direction);
    const Doubles least = broadcast(0x1p-500) * hn::Max(size.x, hn::Max(size.y, size.z));
    return hn::And(is_kept(size.x, least), hn::And(is_kept(size.y, least), is_kept(size.z, least)));
}

HWY_INLINE std::uint64_t bits(DoubleMask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(DoubleTag(), mask, bytes);
    return bytes[0];
}

using NumberTag = hn::RebindToSigned<DoubleTag>;

HWY_INLINE Vec3Lanes gather(const Vec3Span& from, hn::Vec<NumberTag> numbers) {
    const DoubleTag tag;
    return {hn::GatherIndex(tag, from.x, numbers), hn::GatherIndex(tag, from.y, numbers),
            hn::GatherIndex(tag, from.z, numbers)};
}

/// Loads the hits from number i of the group on. They are mostly of neighbouring rays.
HWY_INLINE HitRays hits_of(const SurfaceGroup& g, std::size_t i) {
    const DoubleTag tag;
    const std::uint32_t* numbers = g.numbers + i;
    const std::size_t first = numbers[0], others = std::min(hn::Lanes(tag), g.count - i) - 1;
    if (numbers[others] == first + others && first + hn::Lanes(tag) <= g.rays.count) {
        HitRays hits{load(g.rays.origins, first), load(g.rays.directions, first), hn::Zero(tag)};
        Doubles ignored;
        hn::LoadInterleaved2(tag, &g.hits[first].t, hits.t, ignored);
        return hits;
    }
    const hn::Rebind<std::uint32_t, DoubleTag> half;
    const auto n = hn::BitCast(
        NumberTag(), hn::PromoteTo(hn::RebindToUnsigned<NumberTag>(), hn::LoadU(half, numbers)));
    static_assert(sizeof(Hit) == 2 * sizeof(double));
    return {gather(g.rays.origins, n), gather(g.rays.directions, n),
            hn::GatherIndex(tag, &g.hits[0].t, hn::Add(n, n))};
}

/// Sets the points to the results of the shape's surfaces().
template <class Shape>
std::uint64_t find(const Shape& shape, const SurfacePoint& any, const SurfaceGroup& g) {
    const DoubleTag tag;
    std::uint64_t decided = 0;
    for (std::size_t i = 0; i < g.count; i += hn::Lanes(tag)) {
        const HitRays hits = hits_of(g, i);
        const SurfaceLanes s = surfaces(shape, any, hits);
        store(hits.direction, g.directions, i);
        store(s.position, g.positions, i);
        store(s.error, g.errors, i);
        store(s.normal, g.normals, i);
        store(s.normal, g.shading_normals, i);
        decided |= bits(hn::And(s.decided, is_kept(hits.direction))) << i;
    }
    return decided;
}

std::uint64_t find_sphere(const Sphere& s, const SurfacePoint& any, const SurfaceGroup& group) {
    return find(s, any, group);
}
std::uint64_t find_box(const Box& b, const SurfacePoint& any, const SurfaceGroup& group) {
    return find(b, any, group);
}
std::uint64_t find_plane(const Plane& p, const SurfacePoint& any, const SurfaceGroup& group) {
    return find(p, any, group);
}
std::uint64_t find_polygon(const StoredPolygon& p, const SurfacePoint& any,
                           const SurfaceGroup& group) {
    return find(p, any, group);
}
std::uint64_t find_cone(const Cone& c, const SurfacePoint& any, const SurfaceGroup& group) {
    return find(c, any, group);
}
std::uint64_t find_triangle(const TriangleCorners& p, const SurfacePoint& any,
                            const SurfaceGroup& group) {
    return find(p, any, group);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(find_sphere);
HWY_EXPORT(find_box);
HWY_EXPORT(find_plane);
HWY_EXPORT(find_polygon);
HWY_EXPORT(find_cone);
HWY_EXPORT(find_triangle);

bool has_surface_group(const Geometry& geometry, const Primitive& p) {
    if (p.kind == kind_of<Triangle>()) return p.normal_offset == no_index;
    if (p.kind == kind_of<Polygon>()) return geometry.get<Polygon>(p).normals.empty();
    return p.kind == kind_of<Sphere>() || p.kind == kind_of<Box>() || p.kind == kind_of<Plane>() ||
           p.kind == kind_of<Cone>();
}

std::uint64_t find_surfaces(const Geometry& geometry, const Primitive& p, const SurfacePoint& any,
                            const SurfaceGroup& group) {
    switch (p.kind) {
        case kind_of<Sphere>():
            return HWY_DYNAMIC_DISPATCH(find_sphere)(geometry.get<Sphere>(p), any, group);
        case kind_of<Box>():
            return HWY_DYNAMIC_DISPATCH(find_box)(geometry.get<Box>(p), any, group);
        case kind_of<Plane>():
            return HWY_DYNAMIC_DISPATCH(find_plane)(geometry.get<Plane>(p), any, group);
        case kind_of<Polygon>():
            return HWY_DYNAMIC_DISPATCH(find_polygon)(geometry.get<Polygon>(p), any, group);
        case kind_of<Cone>():
            return HWY_DYNAMIC_DISPATCH(find_cone)(geometry.get<Cone>(p), any, group);
        default: {
            const TriangleCorners corners(geometry, geometry.get<Triangle>(p));
            return HWY_DYNAMIC_DISPATCH(find_triangle)(corners, any, group);
        }
    }
}

}  // namespace etalon
#endif
