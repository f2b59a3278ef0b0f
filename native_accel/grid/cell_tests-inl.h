// What a ray does with the packs of a cell. Compiled for each instruction set.
#if defined(ETALON_GRID_CELL_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_GRID_CELL_TESTS_INL_H
#undef ETALON_GRID_CELL_TESTS_INL_H
#else
#define ETALON_GRID_CELL_TESTS_INL_H
#endif

#include "core/intersect/clusters/filter-inl.h"
#include "native_accel/bvh/slabs-inl.h"
#include "native_accel/grid/cluster_grid.h"
#include "native_accel/grid/sphere_pack_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(id) for the spheres that could be hit; it returns the tmax from then on.
template <class Offer>
class SphereTest {
  public:
    static constexpr std::size_t ahead = 8;

    HWY_INLINE SphereTest(const FrameRay& ray, const Offer& offer) : filter_(ray), offer_(offer) {}

    HWY_INLINE float operator()(const SpherePack& pack, float, float, float tmax) const {
        std::uint32_t lanes = filter_.candidates(pack);
        for (; lanes != 0 && tmax >= 0; lanes &= lanes - 1) {
            tmax = offer_(pack.ids[std::countr_zero(lanes)]);
        }
        return tmax;
    }

  private:
    const SpherePackFilter filter_;
    const Offer& offer_;
};

/// Calls offer(cluster, lane) for the primitives that could be hit, of clusters whose boxes the ray
/// enters; it returns the tmax from then on. A cluster is tested only in the cell in which the ray
/// enters its box, so once, however many cells list it. That cell does list it: see GridWalk.
template <class Offer>
class ClusterTest {
  public:
    static constexpr std::size_t ahead = 1;

    /// For what is met from `entry` on.
    HWY_INLINE ClusterTest(const Clusters& clusters, const FrameRay& ray, float entry,
                           const Offer& offer)
        : clusters_(clusters), slabs_(ray, entry), filter_(ray, entry), offer_(offer) {}

    HWY_INLINE float operator()(const BoxPack& pack, float from, float to, float tmax) const {
        alignas(32) Lanes entry;
        std::uint32_t entered = slabs_.entered(pack.boxes, to, entry);
        if (entered == 0) return tmax;
        const Floats begin = broadcast(from);
        entered &=
            lanes_where([&](std::size_t i) HWY_ATTR { return hn::Ge(load(entry, i), begin); });
        for (; entered != 0; entered &= entered - 1) {
            const int lane = std::countr_zero(entered);
            if (entry[lane] <= tmax) tmax = test(pack.boxes.children[lane].cluster(), tmax);
        }
        return tmax;
    }

  private:
    HWY_INLINE float test(ClusterRef ref, float tmax) const {
        std::uint32_t lanes = filter_.candidates(clusters_, ref, tmax);
        for (; lanes != 0 && tmax >= 0; lanes &= lanes - 1) {
            tmax = offer_(ref, std::countr_zero(lanes));
        }
        return tmax;
    }

    const Clusters& clusters_;
    const Slabs slabs_;
    const ClusterFilter filter_;
    const Offer& offer_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
