#include "embree_backend/instance_tree.h"

#include "core/accel/tree/builder.h"
#include "core/accel/tree/reinsertion.h"
#include "core/intersect/bounded.h"

namespace etalon {
namespace {

/// Half the size, in the scene's space, below which a tree's own space is not made finer, so that
/// rays from anywhere in the scene are resolved.
constexpr double smallest_half = 0x1p-20;

NormalizedSpace space_of(const Geometry& geometry, const NormalizedSpace& scene,
                         const InstanceBounds& bounds, const std::vector<std::uint32_t>& items) {
    Box3 all;
    for (const std::uint32_t item : items) {
        all.extendBy(bounds.boxes[geometry.instance_number(item)]);
    }
    const Vec3 centre = all.center(), least(smallest_half / scene.scale());
    all.extendBy(Box3(centre - least, centre + least));
    return NormalizedSpace(all);
}

}  // namespace

InstanceTree::InstanceTree(const Geometry& geometry, const NormalizedSpace& scene,
                           const InstanceBounds& bounds, std::vector<std::uint32_t> all)
    : items(std::move(all)),
      space(space_of(geometry, scene, bounds, items)),
      spread(bounds.spread) {
    std::vector<BoundedPrimitive> bounded;
    bounded.reserve(items.size());
    for (const std::uint32_t item : items) {
        const Box3& box = bounds.boxes[geometry.instance_number(item)];
        bounded.emplace_back(space.box(box, least_padding.box), item, instance_kind);
    }
    BvhTree binary = reinserted(build_bvh(std::move(bounded), {.max_leaf = 1}));
    const std::vector<Range> ranges = number_leaves(binary);
    wide = widen(binary.nodes, cluster_refs(geometry, binary.ids, ranges));
}

}  // namespace etalon
