#include "core/shading/seen_surfaces.h"

#include <algorithm>

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

/// Input and output of orient().
struct OrientedColumns {
    Vec3Span directions, normals;
    MutableVec3Span shading_normals;
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

/// Turns normals to the ray's side by the steps of surface_interaction().
void orient(const OrientedColumns& c, std::size_t count) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0);
    for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
        const Vec3Lanes normal = load(c.normals, i), shading = load(c.shading_normals, i);
        const DoubleMask entering = load(c.directions, i).dot(normal) < zero;
        const Vec3Lanes ng = negated_unless(entering, normal);
        store(negated_unless(ng.dot(shading) > zero, shading), c.shading_normals, i);
        hn::StoreU(hn::IfThenElse(entering, broadcast(1), broadcast(-1)), tag, c.fronts + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(orient);

namespace {

double scatters(const Material* material) {
    constexpr Color black(0.0F);
    const bool does =
        material == nullptr || material->diffuse != black || material->specular != black;
    return does ? 1.0 : 0.0;
}

double sends_on(const Material* material) {
    constexpr Color black(0.0F);
    if (material == nullptr) return 0;
    return material->transmission != black ? 2 : material->reflection != black ? 1 : 0;
}

}  // namespace

void SeenSurfaces::reset(std::size_t most) {
    for (auto* column : {&directions, &positions, &errors, &normals, &shading_normals}) {
        column->make_room(most);
    }
    for (auto* column : {&fronts, &scatters, &sends_on, &outward_excludes, &inward_excludes}) {
        column->make_room(most);
    }
    traits.make_room(most);
    runs.clear();
    size_ = 0;
}

void SeenSurfaces::find(const Scene& scene, const RayStream& rays, std::span<const Hit> hits) {
    reset(hits.size());
    order_.find(hits);
    const std::span numbers = std::span<const std::uint32_t>(order_.rays).first(order_.size);
    for (const HitRun& run : order_.runs) {
        for (std::uint32_t first = run.first; first < run.last; first += SurfaceGroup::most) {
            const std::size_t count = std::min<std::size_t>(SurfaceGroup::most, run.last - first);
            add_run(scene, rays, hits, numbers.subspan(first, count));
        }
    }
    for (const std::uint32_t i : numbers.subspan(order_.in_runs)) {
        const Ray ray = rays[i];
        add(surface_interaction(scene, ray, hits[i]), ray.direction, i);
    }
}

void SeenSurfaces::add(const SurfaceInteraction& at, const Vec3& direction, std::uint32_t ray) {
    const std::size_t i = size();
    add_traits(at, {&ray, 1});
    directions.set(i, direction);
    set(i, at);
}

/// Adds the entries that are equal for all surfaces on one primitive.
void SeenSurfaces::add_traits(const SurfaceInteraction& any,
                              std::span<const std::uint32_t> numbers) {
    const auto left =
        static_cast<double>(exclusion_of(any.surface.primitive, any.surface.instance));
    const double none = no_index;
    const Convexity convexity = any.surface.convexity;
    const bool is_flat = convexity == Convexity::flat;
    const std::size_t begin = size();
    const auto fill = [&](PaddedColumn<double>& column, double value) {
        std::fill_n(&column[begin], numbers.size(), value);
    };
    fill(scatters, etalon::scatters(any.material));
    fill(sends_on, etalon::sends_on(any.material));
    fill(outward_excludes, is_flat || convexity == Convexity::convex ? left : none);
    fill(inward_excludes, is_flat ? left : none);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        traits[begin + i] = {numbers[i], any.material};
    }
    size_ += numbers.size();
    if (runs.empty() || runs.back().material != any.material) {
        runs.push_back({any.material, begin, begin});
    }
    runs.back().last = size();
}

void SeenSurfaces::set(std::size_t i, const SurfaceInteraction& at) {
    positions.set(i, at.surface.position);
    errors.set(i, at.surface.error);
    normals.set(i, at.surface.normal);
    shading_normals.set(i, at.ns);
    fronts[i] = at.entering ? 1.0 : -1.0;
}

/// Adds the surfaces where rays have hit one primitive: at most SurfaceGroup::most rays.
void SeenSurfaces::add_run(const Scene& scene, const RayStream& rays, std::span<const Hit> hits,
                           std::span<const std::uint32_t> run) {
    const auto interaction = [&](std::uint32_t i) {
        return surface_interaction(scene, rays[i], hits[i]);
    };
    const Primitive primitive = scene.geometry.primitives[hits[run.front()].primitive];
    if (!has_surface_group(scene.geometry, primitive)) {
        for (const std::uint32_t i : run) add(interaction(i), rays.directions[i], i);
        return;
    }
    const SurfaceInteraction any = interaction(run.front());
    const std::size_t begin = size();
    add_traits(any, run);
    const SurfaceGroup group{rays,
                             hits.data(),
                             run.data(),
                             run.size(),
                             directions.span().from(begin),
                             positions.span().from(begin),
                             errors.span().from(begin),
                             normals.span().from(begin),
                             shading_normals.span().from(begin)};
    const std::uint64_t decided = find_surfaces(scene.geometry, primitive, any.surface, group);
    HWY_DYNAMIC_DISPATCH(orient)
    ({group.directions, group.normals, group.shading_normals, &fronts[begin]}, run.size());
    for (std::size_t k = 0; k < run.size(); ++k) {
        if ((decided >> k & 1) == 0) set(begin + k, interaction(run[k]));
    }
}

}  // namespace etalon
#endif
