// Traversal of the grids by a ray. Compiled for each instruction set.
#if defined(ETALON_GRID_TRACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_GRID_TRACE_INL_H
#undef ETALON_GRID_TRACE_INL_H
#else
#define ETALON_GRID_TRACE_INL_H
#endif

#include "core/accel/clusters/instance_list.h"
#include "core/accel/wide/traversal_counters.h"
#include "native_accel/grid/cell_tests-inl.h"
#include "native_accel/grid/grid_trace.h"
#include "native_accel/grid/visit-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(t, id) for what the ray could hit from tmin to tmax in normalized space, and
/// offer_instances(cluster) likewise. Both return the tmax for further tests.
template <class Counters, class Offer, class OfferInstances>
HWY_INLINE void trace(const GridView& grid, const RayQuery& query, const NormalizedRay& local,
                      const float& tmax, Counters counters, const Offer& offer,
                      const OfferInstances& offer_instances) {
    const GridRay ray(local);
    const float tmin = local.tmin(query.ray.tmin);
    const PackedGrid<BoxPack>& boxes = grid.others.boxes();
    if (!boxes.empty()) {
        const RayInterval interval(boxes.box(), ray, tmin, tmax);
        const Clusters& clusters = grid.others.clusters();
        const auto ask = [&](ClusterRef ref, std::size_t lane) HWY_ATTR {
            const auto [id, t] = clusters.intersect_lane(grid.geometry, ref, lane, query);
            return offer(t, id);
        };
        if (!interval.empty()) {
            const ClusterTest test(clusters, query, local, interval.entry, ask, offer_instances,
                                   counters);
            GridVisit(boxes, ray, test, tmax).visit(interval);
        }
    }
    if (!grid.spheres.empty()) {
        const RayInterval interval(grid.spheres.box(), ray, tmin, tmax);
        const auto ask = [&](std::uint32_t id) HWY_ATTR {
            return offer(primitive_first_hit(grid.geometry, id, query), id);
        };
        if (!interval.empty()) {
            const SphereTest test(local, ask, counters);
            GridVisit(grid.spheres, ray, test, tmax).visit(interval);
        }
    }
}

template <class Counters>
HWY_INLINE void find_closest(const GridView& grid, const RayQuery& query,
                             const NormalizedRay& local, NearestHit& nearest, Counters counters) {
    float tmax = local.tmax(nearest.t);
    const auto offer = [&](double t, std::uint32_t id) HWY_ATTR {
        const double before = nearest.t;
        nearest.offer(t, id);
        if (nearest.t < before) tmax = local.tmax(nearest.t);
        return tmax;
    };
    const auto offer_cluster = [&](ClusterRef ref) HWY_ATTR {
        offer_instances(grid.instances, grid.others.clusters(), ref, query, nearest,
                        counters.sum());
        return tmax = local.tmax(nearest.t);
    };
    trace(grid, query, local, tmax, counters, offer, offer_cluster);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
