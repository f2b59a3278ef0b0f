#include "embree_backend/user_primitives.h"

#include <span>

#include "embree_backend/grouping.h"

namespace etalon {
namespace {

/// What Embree's builder wants of primitives, by kind of cluster.
using ByKind = std::array<std::vector<RTCBuildPrimitive>, 3>;

ByKind by_kind(const Scene& scene, const std::vector<BoundedPrimitive>& primitives) {
    ByKind parts;
    parts[ClusterRef::triangles].reserve(scene.all<Triangle>().size());
    parts[ClusterRef::spheres].reserve(scene.all<Sphere>().size());
    for (const BoundedPrimitive& p : primitives) {
        parts[cluster_kind(static_cast<ShapeKind>(p.kind))].push_back(
            {p.min.x, p.min.y, p.min.z, 0, p.max.x, p.max.y, p.max.z, p.id});
    }
    return parts;
}

PrimitiveIds ids_of(const std::vector<RTCBuildPrimitive>& primitives) {
    std::vector<std::uint32_t> ids;
    ids.reserve(primitives.size());
    for (const RTCBuildPrimitive& p : primitives) ids.push_back(p.primID);
    return PrimitiveIds(std::move(ids));
}

void bounds_of_group(const RTCBoundsFunctionArguments* arguments) {
    const Box3f& box = static_cast<const Box3f*>(arguments->geometryUserPtr)[arguments->primID];
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

void bounds_of_single(const RTCBoundsFunctionArguments* arguments) {
    const auto& p =
        static_cast<const RTCBuildPrimitive*>(arguments->geometryUserPtr)[arguments->primID];
    *arguments->bounds_o = {p.lower_x, p.lower_y, p.lower_z, 0, p.upper_x, p.upper_y, p.upper_z, 0};
}

/// A geometry of as many primitives as there are `boxes`, which must be there until it is built.
template <class BoxSource>
void attach(const EmbreeDevice& device, RTCScene target, unsigned number,
            std::span<BoxSource> boxes, RTCBoundsFunction bounds,
            const UserTracing::Callbacks& callbacks) {
    if (boxes.empty()) return;
    const EmbreeOwned<RTCGeometry> geometry(
        rtcNewGeometry(device.handle(), RTC_GEOMETRY_TYPE_USER));
    device.check();
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry.get(), boxes.data());
    rtcSetGeometryBoundsFunction(geometry.get(), bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), callbacks.intersect);
    rtcSetGeometryOccludedFunction(geometry.get(), callbacks.occluded);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(target, geometry.get(), number);
}

}  // namespace

void UserPrimitives::build(const EmbreeDevice& device, RTCScene target, unsigned first,
                           const Frame& frame, std::vector<BoundedPrimitive> primitives) {
    empty_ = primitives.empty();
    auto [singles, triangles, spheres] = by_kind(scene_, primitives);
    primitives = {};
    singles_ = ids_of(singles);
    Grouping groups;
    group(device, std::move(triangles), cluster_lanes, groups);
    const std::size_t triangle_groups = groups.boxes.size();
    group(device, std::move(spheres), cluster_lanes, groups);
    std::vector<ClusterRef> refs;
    clusters_ = Clusters(scene_, frame, groups.ids, groups.ranges, refs);

    const std::span<Box3f> boxes = groups.boxes;
    const auto& [single, triangle, sphere] = tracing_.callbacks;
    attach(device, target, first, std::span(singles), bounds_of_single, single);
    attach(device, target, first + 1, boxes.first(triangle_groups), bounds_of_group, triangle);
    attach(device, target, first + 2, boxes.subspan(triangle_groups), bounds_of_group, sphere);
    device.commit(target);
}

}  // namespace etalon
