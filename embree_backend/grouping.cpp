#include "embree_backend/grouping.h"

#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// What the tree above the leaves is does not matter: they lie one after the other in the array
/// that the builder has sorted.
struct Leaves {
    const RTCBuildPrimitive* first;
    std::vector<std::uint8_t> counts;  ///< by the leaf's first primitive, else 0
};

void* note_leaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, std::size_t count,
                void* leaves) {
    auto& noted = *static_cast<Leaves*>(leaves);
    noted.counts[static_cast<std::size_t>(primitives - noted.first)] =
        static_cast<std::uint8_t>(count);
    return leaves;
}

void* no_node(RTCThreadLocalAllocator, unsigned, void* leaves) {
    return leaves;
}
void no_children(void*, void**, unsigned, void*) {}
void no_bounds(void*, const RTCBounds**, unsigned, void*) {}

/// Sorts the primitives into leaves.
Leaves build_leaves(const EmbreeDevice& device, std::vector<RTCBuildPrimitive>& primitives,
                    unsigned most) {
    Leaves leaves = {primitives.data(), std::vector<std::uint8_t>(primitives.size())};
    const EmbreeOwned<RTCBVH> bvh(rtcNewBVH(device.handle()));
    device.check();
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxBranchingFactor = 8;
    arguments.sahBlockSize = arguments.minLeafSize = arguments.maxLeafSize = most;
    arguments.bvh = bvh.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = no_node;
    arguments.setNodeChildren = no_children;
    arguments.setNodeBounds = no_bounds;
    arguments.createLeaf = note_leaf;
    arguments.userPtr = &leaves;
    rtcBuildBVH(&arguments);
    device.check();
    return leaves;
}

Box3f box_around(const RTCBuildPrimitive* primitives, std::uint32_t count) {
    Box3f box;
    for (std::uint32_t i = 0; i < count; ++i) {
        const RTCBuildPrimitive& p = primitives[i];
        box.extendBy(Vec3f(p.lower_x, p.lower_y, p.lower_z));
        box.extendBy(Vec3f(p.upper_x, p.upper_y, p.upper_z));
    }
    return box;
}

}  // namespace

void group(const EmbreeDevice& device, std::vector<RTCBuildPrimitive> primitives, unsigned most,
           Grouping& groups) {
    if (primitives.empty()) return;
    const Leaves leaves = build_leaves(device, primitives, most);
    const auto offset = static_cast<std::uint32_t>(groups.ids.size());
    groups.ids.reserve(offset + primitives.size());
    for (const RTCBuildPrimitive& p : primitives) groups.ids.push_back(p.primID);
    const std::size_t before = groups.ranges.size();
    for (std::uint32_t i = 0; i < primitives.size(); i += leaves.counts[i]) {
        groups.ranges.push_back({offset + i, leaves.counts[i]});
    }
    groups.boxes.resize(groups.ranges.size());
    parallel_for(groups.ranges.size() - before, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = before + begin; i < before + end; ++i) {
            const Range& range = groups.ranges[i];
            groups.boxes[i] = box_around(&primitives[range.first - offset], range.count);
        }
    });
}

}  // namespace etalon
