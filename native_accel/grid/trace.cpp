#include "native_accel/grid/trace.h"

#include <algorithm>

#include "core/intersect/clusters/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native_accel/grid/trace.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "native_accel/grid/cell_tests-inl.h"
#include "native_accel/grid/visit-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(t, id), which returns the tmax from then on, for what the ray could hit from tmin to
/// tmax in the frame.
template <class Offer>
HWY_INLINE void trace(const GridView& grid, const RayQuery& query, const FrameRay& local,
                      const float& tmax, const Offer& offer) {
    const GridRay ray(local);
    const float tmin = std::max(0.0F, local.tmin(query.ray.tmin));
    const PackedGrid<BoxPack>& boxes = grid.others.boxes();
    if (!boxes.empty()) {
        const Passage passage(boxes.box(), ray, tmin, tmax);
        const Clusters& clusters = grid.others.clusters();
        const auto ask = [&](ClusterRef ref, std::size_t lane) HWY_ATTR {
            const auto [id, t] = clusters.ask(grid.scene, ref, lane, query);
            return offer(t, id);
        };
        if (!passage.empty()) {
            const ClusterTest test(clusters, local, passage.entry, query.ray.left, ask);
            GridVisit(boxes, ray, test, tmax).visit(passage);
        }
    }
    if (!grid.spheres.empty()) {
        const Passage passage(grid.spheres.box(), ray, tmin, tmax);
        const auto ask = [&](std::uint32_t id) HWY_ATTR {
            return offer(primitive_first_hit(grid.scene, id, query), id);
        };
        if (!passage.empty()) {
            const SphereTest test(local, ask);
            GridVisit(grid.spheres, ray, test, tmax).visit(passage);
        }
    }
}

void trace_closest(const GridView& grid, const RayQuery& query, const FrameRay& local,
                   NearestHit& nearest) {
    float tmax = local.tmax(nearest.t);
    trace(grid, query, local, tmax, [&](double t, std::uint32_t id) HWY_ATTR {
        const double before = nearest.t;
        nearest.offer(t, id);
        if (nearest.t < before) tmax = local.tmax(nearest.t);
        return tmax;
    });
}

bool trace_occluded(const GridView& grid, const RayQuery& query, const FrameRay& local) {
    constexpr float nowhere = -std::numeric_limits<float>::infinity();
    float tmax = local.tmax(query.ray.tmax);
    bool found = false;
    trace(grid, query, local, tmax, [&](double t, std::uint32_t) HWY_ATTR {
        found = t <= query.ray.tmax;
        if (found) tmax = nowhere;
        return tmax;
    });
    return found;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(trace_closest);
HWY_EXPORT(trace_occluded);

void trace_closest(const GridView& grid, const RayQuery& query, const FrameRay& local,
                   NearestHit& nearest) {
    HWY_DYNAMIC_DISPATCH(trace_closest)(grid, query, local, nearest);
}

bool trace_occluded(const GridView& grid, const RayQuery& query, const FrameRay& local) {
    return HWY_DYNAMIC_DISPATCH(trace_occluded)(grid, query, local);
}

}  // namespace etalon
#endif
