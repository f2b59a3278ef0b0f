// Vectors of as many of the eight floats of a cluster or a node as one instruction takes. Compiled
// for each instruction set.
#if defined(ETALON_CLUSTERS_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CLUSTERS_LANES_INL_H
#undef ETALON_CLUSTERS_LANES_INL_H
#else
#define ETALON_CLUSTERS_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "core/accel/clusters/cluster.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, cluster_lanes>;
using Floats = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

/// Returns the bits of a mask of the lanes from `first` on, each at the number of its lane.
HWY_INLINE std::uint32_t bits(Mask mask, std::size_t first) {
    std::uint8_t byte = 0;
    hn::StoreMaskBits(Tag(), mask, &byte);
    return static_cast<std::uint32_t>(byte) << first;
}

HWY_INLINE Floats broadcast(float x) {
    return hn::Set(Tag(), x);
}
HWY_INLINE Floats load(const Lanes& lanes, std::size_t first) {
    return hn::Load(Tag(), &lanes[first]);
}

/// Returns the lanes that hold the primitive `id`.
HWY_INLINE Mask holds(const Ids& ids, std::size_t first, std::uint32_t id) {
    const hn::Rebind<std::uint32_t, Tag> numbers;
    return hn::RebindMask(Tag(), hn::Eq(hn::Load(numbers, &ids[first]), hn::Set(numbers, id)));
}

/// Returns the lanes, lowest first, for which the test holds. test(i) tests lane i and those after
/// it.
template <class Test>
HWY_INLINE std::uint32_t lanes_where(const Test& test) {
    std::uint32_t found = 0;
    for (std::size_t i = 0; i < cluster_lanes; i += hn::MaxLanes(Tag())) {
        found |= bits(test(i), i);
    }
    return found;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
