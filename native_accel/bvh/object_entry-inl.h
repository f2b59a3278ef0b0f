// Rays that go from the tree of instances into the trees of their objects. Compiled for each
// instruction set.
#if defined(ETALON_BVH_OBJECT_ENTRY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_BVH_OBJECT_ENTRY_INL_H
#undef ETALON_BVH_OBJECT_ENTRY_INL_H
#else
#define ETALON_BVH_OBJECT_ENTRY_INL_H
#endif

#include "core/intersect/object_ray-inl.h"
#include "native_accel/bvh/queries-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 32

/// Traverses the trees of objects without calling their intersectors, as most instances that a ray
/// is tested against are missed, or left after a node or two. Rare cases take the path of
/// AnyInstances.
class EnteredInstances {
  public:
    HWY_INLINE EnteredInstances(const BvhView& bvh, const Ray& ray) : bvh_(bvh), world_(ray) {}

    HWY_INLINE void offer(ClusterRef ref, const RayQuery& query, NearestHit& nearest,
                          TraversalCost*) const {
        bvh_.clusters.visit_instances(ref, [&](std::uint32_t item) HWY_ATTR {
            offer_item(item, query, nearest);
            return true;
        });
    }

    HWY_INLINE bool occlude(ClusterRef ref, const RayQuery& query) const {
        bool found = false;
        bvh_.clusters.visit_instances(ref, [&](std::uint32_t item) HWY_ATTR {
            found = occludes(item, query);
            return !found;
        });
        return found;
    }

  private:
    std::uint32_t number(std::uint32_t item) const { return bvh_.geometry.instance_number(item); }
    const Instance& instance(std::uint32_t item) const {
        return bvh_.geometry.instances[number(item)];
    }

    HWY_INLINE void offer_item(std::uint32_t item, const RayQuery& query,
                               NearestHit& nearest) const {
        const Instance& placed = instance(item);
        const BvhObject& object = bvh_.objects[placed.object];
        if (HWY_UNLIKELY(placed.moves() || !object.is_plain)) {
            return bvh_.instances.offer_instance(item, query, nearest);
        }
        const ObjectRay ray(placed, world_);
        NormalizedRay local;
        const ObjectEntry entry = ray.entry(object.space, local);
        if (entry == ObjectEntry::misses) return;
        if (HWY_UNLIKELY(entry == ObjectEntry::slow_path)) {
            return bvh_.instances.offer_instance(item, query, nearest);
        }
        NearestHit inside(nearest.t);
        enter(object.view, ray, local, query.ray, number(item), inside);
        if (inside.found()) nearest.offer(inside.t, item, inside.item);
    }

    HWY_INLINE bool occludes(std::uint32_t item, const RayQuery& query) const {
        const Instance& placed = instance(item);
        const BvhObject& object = bvh_.objects[placed.object];
        if (HWY_UNLIKELY(placed.moves() || !object.is_plain)) {
            return bvh_.instances.instance_occludes(item, query);
        }
        const ObjectRay ray(placed, world_);
        NormalizedRay local;
        const ObjectEntry entry = ray.entry(object.space, local);
        if (entry == ObjectEntry::misses) return false;
        if (HWY_UNLIKELY(entry == ObjectEntry::slow_path)) {
            return bvh_.instances.instance_occludes(item, query);
        }
        return is_met(object.view, ray, local, query.ray, number(item));
    }

    static HWY_NOINLINE void enter(const BvhView& object, const ObjectRay& ray,
                                   const NormalizedRay& local, const Ray& world,
                                   std::uint32_t instance, NearestHit& nearest) {
        const float tmin = local.tmin(world.tmin);
        const Slabs boxes(local, tmin);
        const double tmax = nearest.t;
        const auto make_query = [&]() HWY_ATTR { return RayQuery(ray.ray(world, tmax, instance)); };
        const AnyInstances none(object);
        if (object.predicts_branches(world)) {
            find_closest<BranchingLaneSelect>(object, make_query, local, tmin, boxes, none, nearest,
                                              Uncounted());
        } else {
            find_closest<BranchlessLaneSelect>(object, make_query, local, tmin, boxes, none,
                                               nearest, Uncounted());
        }
    }

    static HWY_NOINLINE bool is_met(const BvhView& object, const ObjectRay& ray,
                                    const NormalizedRay& local, const Ray& world,
                                    std::uint32_t instance) {
        const float tmin = local.tmin(world.tmin);
        const Slabs boxes(local, tmin);
        const auto make_query = [&]() HWY_ATTR {
            return RayQuery(ray.ray(world, world.tmax, instance));
        };
        const AnyInstances none(object);
        return object.predicts_branches(world)
                   ? find_any<BranchingLaneSelect>(object, make_query, world.tmax, local, tmin,
                                                   boxes, none)
                   : find_any<BranchlessLaneSelect>(object, make_query, world.tmax, local, tmin,
                                                    boxes, none);
    }

    const BvhView& bvh_;
    const WorldRayLanes world_;
};

#else

class EnteredInstances : public AnyInstances {
  public:
    HWY_INLINE EnteredInstances(const BvhView& bvh, const Ray&) : AnyInstances(bvh) {}
};

#endif

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
