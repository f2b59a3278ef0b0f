#include "native_accel/grid/cluster_grid.h"

#include "core/accel/tree/scene_tree.h"

namespace etalon {

ClusterGrid::ClusterGrid(const Geometry& geometry, const NormalizedSpace& space,
                         std::vector<BoundedPrimitive> primitives) {
    BvhTree tree = build_scene_bvh(geometry, space, std::move(primitives));
    std::vector<Range> ranges;
    std::vector<BoxItem> items;
    for (const BvhNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        ranges.push_back({node.first, node.count});
        items.push_back({node.box, 0});
    }
    std::vector<BvhNode>().swap(tree.nodes);
    const std::vector<ClusterRef> refs = cluster_refs(geometry, tree.ids, ranges);
    for (std::size_t i = 0; i < items.size(); ++i) items[i].id = refs[i].bits;
    boxes_ = PackedGrid<BoxPack>(items);
    std::vector<BoxItem>().swap(items);  // before building the clusters, which take the most
    clusters_ = Clusters(geometry, space, tree.ids, ranges, refs);
}

}  // namespace etalon
