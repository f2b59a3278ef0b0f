// Conservative float filter for the primitives of a cluster, eight at once. Every primitive that
// the kernel would hit passes; the kernel decides about those that pass. Compiled for each
// instruction set.
#if defined(ETALON_CLUSTERS_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CLUSTERS_FILTER_INL_H
#undef ETALON_CLUSTERS_FILTER_INL_H
#else
#define ETALON_CLUSTERS_FILTER_INL_H
#endif

#include <new>

#include "core/accel/clusters/clusters.h"
#include "core/accel/clusters/sphere_filter-inl.h"
#include "core/accel/clusters/triangle_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Filter for a cluster of any kind.
class ClusterFilter {
  public:
    /// Sets up the filter for spheres only if there are any.
    HWY_INLINE ClusterFilter(const Clusters& clusters, const RayQuery& query,
                             const NormalizedRay& ray, float tmin)
        : triangles_(query, ray) {
        if (clusters.has_spheres()) new (&spheres_) SphereFilter(ray, tmin, query.ray.excluded());
    }

    /// Returns the lanes, lowest first, that the ray could hit at tmin < t <= tmax in normalized
    /// space. Of a list, returns all lanes, used or not.
    HWY_INLINE std::uint32_t candidates(const Clusters& clusters, ClusterRef ref,
                                        float tmax) const {
        switch (ref.kind()) {
            case ClusterRef::triangles:
                return triangles_.candidates(clusters.triangles(ref), tmax);
            case ClusterRef::spheres:
                return spheres_.candidates(clusters.spheres(ref), tmax);
            default:
                return (1U << cluster_lanes) - 1;
        }
    }

  private:
    TriangleFilter triangles_;
    union {
        SphereFilter spheres_;
    };
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
