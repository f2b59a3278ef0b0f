#include "embree_backend/user_primitives.h"

#include <algorithm>

#include "core/accel/tree/scene_tree.h"

namespace etalon {
namespace {

using Boxes = std::vector<Box3f>;

bool is_single(const BoundedPrimitive& p) {
    const ClusterRef::Kind kind = cluster_kind(static_cast<ShapeKind>(p.kind));
    return kind == ClusterRef::list || kind == ClusterRef::instances;
}

/// Removes the primitives that have no filter from `primitives` and returns them.
std::vector<BoundedPrimitive> take_singles(std::vector<BoundedPrimitive>& primitives) {
    std::vector<BoundedPrimitive> singles;
    std::copy_if(primitives.begin(), primitives.end(), std::back_inserter(singles), is_single);
    if (!singles.empty()) std::erase_if(primitives, is_single);
    return singles;
}

PrimitiveIds ids_of(const std::vector<BoundedPrimitive>& primitives) {
    std::vector<std::uint32_t> ids;
    ids.reserve(primitives.size());
    for (const BoundedPrimitive& p : primitives) ids.push_back(p.id);
    return PrimitiveIds(std::move(ids));
}

Boxes boxes_of(const std::vector<BoundedPrimitive>& primitives) {
    Boxes boxes;
    boxes.reserve(primitives.size());
    for (const BoundedPrimitive& p : primitives) boxes.push_back(p.box());
    return boxes;
}

/// Returns the leaves of a tree as clusters, and sets their boxes by kind of cluster.
Clusters cluster(const Geometry& geometry, const NormalizedSpace& space, BvhTree tree,
                 std::array<Boxes, UserPrimitives::geometries>& boxes) {
    std::vector<Range> ranges;
    for (const BvhNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        ranges.push_back({node.first, node.count});
        boxes[cluster_kind(geometry.primitives[tree.ids[node.first]].kind)].push_back(node.box);
    }
    std::vector<BvhNode>().swap(tree.nodes);  // before building the clusters, which take the most
    return Clusters(geometry, space, tree.ids, ranges, cluster_refs(geometry, tree.ids, ranges));
}

void bounds_of_box(const RTCBoundsFunctionArguments* arguments) {
    const Box3f& box = static_cast<const Box3f*>(arguments->geometryUserPtr)[arguments->primID];
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

/// Attaches a geometry of as many primitives as there are `boxes`, which must exist until it is
/// built.
void attach(const EmbreeDevice& device, RTCScene target, unsigned number, Boxes& boxes,
            const UserTracing::Callbacks& callbacks) {
    if (boxes.empty()) return;
    const EmbreeOwned<RTCGeometry> geometry(
        rtcNewGeometry(device.handle(), RTC_GEOMETRY_TYPE_USER));
    device.check();
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry.get(), boxes.data());
    rtcSetGeometryBoundsFunction(geometry.get(), bounds_of_box, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), callbacks.intersect);
    rtcSetGeometryOccludedFunction(geometry.get(), callbacks.occluded);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(target, geometry.get(), number);
}

}  // namespace

UserPrimitives::UserPrimitives(const Geometry& geometry, const Intersector& instances,
                               const std::vector<UserView>* objects)
    : geometry_(geometry), instances_(instances), entered_(objects) {}

std::size_t UserPrimitives::memory_bytes() const {
    return clusters_.memory_bytes() + singles_.memory_bytes() + trees_.memory_bytes() +
           objects_.capacity() * sizeof(ObjectSpace);
}

void UserPrimitives::build(const EmbreeDevice& device, RTCScene target,
                           const NormalizedSpace& space, std::vector<BoundedPrimitive> primitives) {
    empty_ = primitives.empty();
    std::vector<BoundedPrimitive> singles = take_singles(primitives);
    trees_ = InstanceTrees(geometry_, space, singles);
    singles_ = ids_of(singles);
    objects_ = instances_.object_spaces();
    std::array<Boxes, geometries> boxes;
    boxes[ClusterRef::list] = boxes_of(singles);
    clusters_ =
        cluster(geometry_, space, build_scene_bvh(geometry_, space, std::move(primitives)), boxes);
    for (unsigned kind = 0; kind < boxes.size(); ++kind) {
        attach(device, target, kind, boxes[kind], tracing_.callbacks[kind]);
    }
    device.commit(target);
    view_.emplace(UserView{target, geometry_, clusters_, singles_, instances_, objects_.data(),
                           trees_, entered_ ? entered_->data() : nullptr});
}

}  // namespace etalon
