#include "embree_backend/user_primitives.h"

#include <span>

#include "embree_backend/grouping.h"

namespace etalon {
namespace {

/// How many primitives share a box, by kind of cluster. Those without a filter gain nothing.
constexpr std::array<unsigned, 3> cluster_sizes = {1, cluster_lanes, cluster_lanes};

using ByKind = std::array<std::vector<RTCBuildPrimitive>, 3>;

ClusterRef::Kind kind_for(const Primitive& primitive) {
    if (primitive.kind == kind_of<Triangle>()) return ClusterRef::triangles;
    if (primitive.kind == kind_of<Sphere>()) return ClusterRef::spheres;
    return ClusterRef::list;
}

ByKind by_kind(const Scene& scene, const std::vector<BoundedPrimitive>& primitives) {
    ByKind parts;
    parts[ClusterRef::triangles].reserve(scene.all<Triangle>().size());
    parts[ClusterRef::spheres].reserve(scene.all<Sphere>().size());
    for (const BoundedPrimitive& p : primitives) {
        const Vec3f &min = p.box.min, &max = p.box.max;
        parts[kind_for(scene.primitives[p.id])].push_back(
            {min.x, min.y, min.z, 0, max.x, max.y, max.z, p.id});
    }
    return parts;
}

void bounds(const RTCBoundsFunctionArguments* arguments) {
    const Box3f& box = static_cast<const Box3f*>(arguments->geometryUserPtr)[arguments->primID];
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

/// One primitive of Embree's for each of `boxes`, which must be there until it is built.
void attach(const EmbreeDevice& device, RTCScene target, unsigned number, std::span<Box3f> boxes,
            const UserTracing::Callbacks& callbacks) {
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
    ByKind parts = by_kind(scene_, primitives);
    primitives = {};
    Grouping groups;
    std::array<std::size_t, 4> ends = {};
    for (std::size_t kind = 0; kind < parts.size(); ++kind) {
        group(device, std::move(parts[kind]), cluster_sizes[kind], groups);
        ends[kind + 1] = groups.boxes.size();
    }
    std::vector<ClusterRef> refs;
    clusters_ = Clusters(scene_, frame, groups.ids, groups.ranges, refs);
    for (unsigned kind = 0; kind < parts.size(); ++kind) {
        const std::span<Box3f> boxes =
            std::span(groups.boxes).subspan(ends[kind], ends[kind + 1] - ends[kind]);
        if (!boxes.empty()) {
            attach(device, target, first + kind, boxes, tracing_.callbacks[kind]);
        }
    }
    device.commit(target);
}

}  // namespace etalon
