// A ray on its way through a scene of user geometry. Compiled for each instruction set.
#if defined(ETALON_USER_QUERY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_USER_QUERY_INL_H
#undef ETALON_USER_QUERY_INL_H
#else
#define ETALON_USER_QUERY_INL_H
#endif

#include <new>

#include "core/accel/clusters/filter-inl.h"
#include "embree_backend/query.h"
#include "embree_backend/user_tracing.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Filter that is lazily made for the first cluster a ray meets: many rays meet none of one kind.
template <class Filter>
class Lazy {
  public:
    HWY_INLINE Lazy() {}

    template <class Make>
    HWY_INLINE const Filter& get(const Make& make) {
        if (HWY_UNLIKELY(!made_)) new (&filter_) Filter(make());
        made_ = true;
        return filter_;
    }

  private:
    union {
        Filter filter_;
    };
    bool made_ = false;
};

/// Input of the callbacks for one ray: Embree passes them the context that it was given.
struct UserQuery : EmbreeContext {
    HWY_INLINE UserQuery(const UserView& v, const RayQuery& q, const NormalizedRay& l,
                         NearestHit* n)
        : view(v), query(q), local(l), nearest(n) {
        initialise(*this);
    }

    /// Returns whether the number of a single is that of an instance tree, not an item's.
    bool is_tree(std::uint32_t single) const { return single >= view.geometry.item_count(); }
    std::uint32_t tree_index(std::uint32_t single) const {
        return single - view.geometry.item_count();
    }

    /// Takes over `hit`, a copy of `nearest` after further offers, if it has changed, and if no hit
    /// of Embree's own geometries, whose t is in tfar, is nearer. Returns whether it did.
    HWY_INLINE bool take_over(const NearestHit& hit, RTCRay& ray) {
        if (!(hit.t < nearest->t || hit.item != nearest->item)) return false;
        const float tfar = local.tmax(hit.t);
        if (tfar > ray.tfar) return false;
        *nearest = hit;
        ray.tfar = tfar;
        return true;
    }

    /// Returns the lanes, lowest first, that the ray could hit from its tnear to its tfar; one lane
    /// for items without a filter.
    template <ClusterRef::Kind kind>
    HWY_INLINE std::uint32_t candidates(std::uint32_t cluster, const RTCRay& ray) {
        const ClusterRef ref(kind, cluster);
        if constexpr (kind == ClusterRef::list) return 1;
        if constexpr (kind == ClusterRef::triangles) {
            const auto make = [&]() HWY_ATTR { return TriangleFilter(query, local); };
            return triangles.get(make).candidates(view.clusters.triangles(ref), ray.tfar);
        }
        if constexpr (kind == ClusterRef::spheres) {
            const auto make = [&]() HWY_ATTR {
                return SphereFilter(local, ray.tnear, query.ray.excluded());
            };
            return spheres.get(make).candidates(view.clusters.spheres(ref), ray.tfar);
        }
    }

    const UserView& view;
    const RayQuery& query;
    const NormalizedRay& local;
    NearestHit* nearest;
    std::uint32_t visited_tree = no_index;  ///< index of one that is done, if any
    Lazy<TriangleFilter> triangles;
    Lazy<SphereFilter> spheres;
};

/// See instance_tree-inl.h.
void visit_tree_about_start(UserQuery& query, RTCRay& ray);

inline void intersect(const UserView& view, const RayQuery& query, const NormalizedRay& local,
                      NearestHit& nearest, RTCRayHit& ray) {
    UserQuery context(view, query, local, &nearest);
    if (HWY_UNLIKELY(!view.trees.empty())) visit_tree_about_start(context, ray.ray);
    embree_intersect(view.target, context, ray);
}

inline void occluded(const UserView& view, const RayQuery& query, const NormalizedRay& local,
                     RTCRay& ray) {
    UserQuery context(view, query, local, nullptr);
    embree_occluded(view.target, context, ray);
}

/// Returns the ray of a packet of one, which has the layout of a single ray.
template <class Ray, class PacketOfOne>
HWY_INLINE Ray& single(PacketOfOne* packet) {
    return *reinterpret_cast<Ray*>(packet);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
