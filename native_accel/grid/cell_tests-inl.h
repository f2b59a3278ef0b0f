// Tests of a ray with the packs of a cell. Compiled for each instruction set.
#if defined(ETALON_GRID_CELL_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_GRID_CELL_TESTS_INL_H
#undef ETALON_GRID_CELL_TESTS_INL_H
#else
#define ETALON_GRID_CELL_TESTS_INL_H
#endif

#include <algorithm>
#include <bit>
#include <span>

#include "core/accel/clusters/filter-inl.h"
#include "core/accel/wide/slabs-inl.h"
#include "native_accel/grid/cluster_grid.h"
#include "native_accel/grid/sphere_pack_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Calls offer(id) for the spheres that could be hit. It returns the tmax for further tests.
template <class Offer, class Counters>
class SphereTest {
  public:
    HWY_INLINE SphereTest(const NormalizedRay& ray, const Offer& offer, Counters to)
        : counters(to), filter_(ray), offer_(offer) {}

    HWY_INLINE float operator()(std::span<const SpherePack> packs, float, float, float tmax) const {
        for (const SpherePack& pack : packs) {
            counters.members(pack);
            std::uint32_t lanes = filter_.candidates(pack);
            for (; lanes != 0 && tmax >= 0; lanes &= lanes - 1) {
                tmax = offer_(pack.ids[std::countr_zero(lanes)]);
            }
        }
        return tmax;
    }

    [[no_unique_address]] const Counters counters;

  private:
    const SpherePackFilter filter_;
    const Offer& offer_;
};

/// Calls offer(cluster, lane) for the primitives that could be hit, of clusters whose boxes the ray
/// enters, and offer_instances(cluster) for clusters of instances. Both return the tmax for further
/// tests. A cluster is tested only in the cell in which the ray enters its box, so once, however
/// many cells list it. That cell does list it: see GridTraversal.
template <class Offer, class OfferInstances, class Counters>
class ClusterTest {
  public:
    /// Tests only what the ray meets from `entry` on.
    HWY_INLINE ClusterTest(const Clusters& clusters, const RayQuery& query,
                           const NormalizedRay& ray, float entry, const Offer& offer,
                           const OfferInstances& offer_instances, Counters to)
        : counters(to),
          clusters_(clusters),
          slabs_(ray, entry),
          filter_(clusters, query, ray, entry),
          offer_(offer),
          offer_instances_(offer_instances) {}

    HWY_INLINE float operator()(std::span<const BoxPack> packs, float from, float to,
                                float tmax) const {
        while (!packs.empty() && from <= tmax) {
            const auto some = packs.first(std::min(packs.size(), most));
            tmax = test(some, from, to, tmax);
            packs = packs.subspan(some.size());
        }
        return tmax;
    }

    [[no_unique_address]] const Counters counters;

  private:
    static constexpr std::size_t most = 64 / node_width;  ///< packs whose lanes fit one 64-bit mask

    /// First tests all boxes, without unpredictable branches, then what the ray enters.
    HWY_INLINE float test(std::span<const BoxPack> packs, float from, float to, float tmax) const {
        alignas(32) std::array<Lanes, most> entry;
        std::uint64_t entered = 0;
        for (std::size_t i = 0; i < packs.size(); ++i) {
            counters.boxes(packs[i].boxes);
            const std::uint64_t lanes = entered_in(packs[i].boxes, from, to, entry[i]);
            entered |= lanes << (i * node_width);
        }
        for (; entered != 0; entered &= entered - 1) {
            const auto bit = static_cast<std::size_t>(std::countr_zero(entered));
            const std::size_t pack = bit / node_width, lane = bit % node_width;
            if (entry[pack][lane] > tmax) continue;
            tmax = test(packs[pack].boxes.children[lane].cluster(), tmax);
        }
        return tmax;
    }

    /// Returns the lanes whose box is entered within [from, to], and the t of entry.
    HWY_INLINE std::uint32_t entered_in(const WideNode& boxes, float from, float to,
                                        Lanes& entry) const {
        const std::uint32_t before_end = slabs_.entered(boxes, to, entry);
        const Floats begin = broadcast(from);
        return before_end &
               lanes_where([&](std::size_t i) HWY_ATTR { return hn::Ge(load(entry, i), begin); });
    }

    HWY_INLINE float test(ClusterRef ref, float tmax) const {
        counters.members(clusters_, ref);
        if (HWY_UNLIKELY(ref.kind() == ClusterRef::instances)) return offer_instances_(ref);
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
    const OfferInstances& offer_instances_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
