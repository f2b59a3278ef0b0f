#include "core/shading/seen_surfaces.h"

#include "core/intersect/kernels.h"
#include "core/intersect/surface_group.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shading/seen_surfaces.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

#ifndef ETALON_SEEN_SURFACES_ONCE
#define ETALON_SEEN_SURFACES_ONCE
namespace etalon {

/// What is known of surfaces, and where what it means for the rays goes.
struct OrientedColumns {
    const Vec3 *directions, *normals;
    Vec3* shading_normals;
    double* fronts;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

HWY_INLINE Vec3Lanes negated_unless(DoubleMask mask, const Vec3Lanes& v) {
    return {hn::IfThenElse(mask, v.x, hn::Neg(v.x)), hn::IfThenElse(mask, v.y, hn::Neg(v.y)),
            hn::IfThenElse(mask, v.z, hn::Neg(v.z))};
}

/// The steps of surface_interaction().
void orient(const OrientedColumns& c, std::size_t count) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0);
    for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
        const Vec3Lanes normal = load(c.normals + i), shading = load(c.shading_normals + i);
        const DoubleMask entering = load(c.directions + i).dot(normal) < zero;
        const Vec3Lanes ng = negated_unless(entering, normal);
        store(negated_unless(ng.dot(shading) > zero, shading), c.shading_normals + i);
        hn::StoreU(hn::IfThenElse(entering, broadcast(1), broadcast(-1)), tag, c.fronts + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(orient);

namespace {

bool scatters(const Material* material) {
    constexpr Color black(0.0F);
    return material == nullptr || material->diffuse != black || material->specular != black;
}

SeenSurfaces::Traits traits_of(const SurfacePoint& p, const Material* material, std::uint32_t ray) {
    return {ray, p.primitive, material, p.convexity, scatters(material)};
}

}  // namespace

SeenSurfaces::SeenSurfaces(std::size_t most) {
    const std::size_t room = most + HWY_NAMESPACE::padded_doubles;
    for (auto* column : {&directions, &positions, &errors, &normals, &shading_normals}) {
        column->resize(room);
    }
    fronts.resize(room);
    traits.reserve(most);
}

SeenSurfaces::SeenSurfaces(const Scene& scene, std::span<const Ray> rays, std::span<const Hit> hits)
    : SeenSurfaces(hits.size()) {
    const HitOrder order(hits);
    const std::span numbers(order.rays);
    for (const HitRun& run : order.runs) {
        for (std::uint32_t first = run.first; first < run.last; first += SurfaceGroup::most) {
            const std::size_t count = std::min<std::size_t>(SurfaceGroup::most, run.last - first);
            add_run(scene, rays, hits, numbers.subspan(first, count));
        }
    }
    for (const std::uint32_t i : numbers.subspan(order.in_runs)) {
        add(surface_interaction(scene, rays[i], hits[i]), rays[i].direction, i);
    }
}

void SeenSurfaces::add(const SurfaceInteraction& at, const Vec3& direction, std::uint32_t ray) {
    const std::size_t i = size();
    directions[i] = direction;
    set(i, at);
    traits.push_back(traits_of(at.surface, at.material, ray));
}

void SeenSurfaces::set(std::size_t i, const SurfaceInteraction& at) {
    positions[i] = at.surface.position;
    errors[i] = at.surface.error;
    normals[i] = at.surface.normal;
    shading_normals[i] = at.ns;
    fronts[i] = at.entering ? 1.0 : -1.0;
}

/// Adds where rays have hit one primitive: at most SurfaceGroup::most of them.
void SeenSurfaces::add_run(const Scene& scene, std::span<const Ray> rays, std::span<const Hit> hits,
                           std::span<const std::uint32_t> run) {
    const auto interaction = [&](std::uint32_t i) {
        return surface_interaction(scene, rays[i], hits[i]);
    };
    const Primitive primitive = scene.geometry.primitives[hits[run.front()].primitive];
    if (!has_surface_group(primitive)) {
        for (const std::uint32_t i : run) add(interaction(i), rays[i].direction, i);
        return;
    }
    const SurfaceInteraction any = interaction(run.front());
    const std::size_t begin = size();
    SurfaceGroup group;
    group.count = run.size();
    for (std::size_t k = 0; k < run.size(); ++k) {
        const Ray& ray = rays[run[k]];
        group.origins[k] = ray.origin;
        group.ts[k] = hits[run[k]].t;
        directions[begin + k] = ray.direction;
        traits.push_back(traits_of(any.surface, any.material, run[k]));
    }
    group.directions = &directions[begin];
    group.positions = &positions[begin];
    group.errors = &errors[begin];
    group.normals = &normals[begin];
    group.shading_normals = &shading_normals[begin];
    const std::uint64_t decided = find_surfaces(scene.geometry, primitive, any.surface, group);
    HWY_DYNAMIC_DISPATCH(orient)
    ({group.directions, group.normals, group.shading_normals, &fronts[begin]}, run.size());
    for (std::size_t k = 0; k < run.size(); ++k) {
        if ((decided >> k & 1) == 0) set(begin + k, interaction(run[k]));
    }
}

}  // namespace etalon
#endif
