#include "embree_backend/user_primitives.h"

#include "core/intersect/kernels.h"
#include "embree_backend/query.h"

namespace etalon {
namespace {

std::vector<std::uint32_t> ids_of(const std::vector<BoundedPrimitive>& primitives) {
    std::vector<std::uint32_t> ids;
    ids.reserve(primitives.size());
    for (const BoundedPrimitive& p : primitives) ids.push_back(p.id);
    return ids;
}

/// Embree's single-ray layout is what a packet of one is.
template <class Ray, class PacketOfOne>
Ray& single(PacketOfOne* packet) {
    return *reinterpret_cast<Ray*>(packet);
}

}  // namespace

void UserPrimitives::build(const EmbreeDevice& device, RTCScene target, unsigned geometry_id,
                           std::vector<BoundedPrimitive> primitives) {
    boxes_ = std::move(primitives);
    ids_ = PrimitiveIds(ids_of(boxes_));
    const EmbreeOwned<RTCGeometry> geometry(
        rtcNewGeometry(device.handle(), RTC_GEOMETRY_TYPE_USER));
    device.check();
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes_.size()));
    rtcSetGeometryUserData(geometry.get(), this);
    rtcSetGeometryBoundsFunction(geometry.get(), bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), intersect);
    rtcSetGeometryOccludedFunction(geometry.get(), occluded);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(target, geometry.get(), geometry_id);
    device.commit(target);
    boxes_ = {};
}

void UserPrimitives::bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto& self = *static_cast<const UserPrimitives*>(arguments->geometryUserPtr);
    const BoundedPrimitive& box = self.boxes_[arguments->primID];
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

/// What is offered at t may lie behind a hit that is not in `nearest`: one on a geometry of
/// Embree's own, which its tfar tells.
void UserPrimitives::intersect(const RTCIntersectFunctionNArguments* arguments) {
    const auto& self = *static_cast<const UserPrimitives*>(arguments->geometryUserPtr);
    auto& query = *static_cast<EmbreeQuery*>(arguments->context);
    auto& [ray, hit] = single<RTCRayHit>(arguments->rayhit);
    const std::uint32_t id = self.ids_[arguments->primID];
    const double t = primitive_first_hit(self.scene_, id, query.query);
    report(*arguments, false);
    if (!(t <= query.nearest.t)) return;
    const float tfar = query.local.tmax(t);
    if (tfar > ray.tfar) return;
    query.nearest.offer(t, id);
    ray.tfar = tfar;
    hit.geomID = arguments->geomID;
    report(*arguments, true);
}

void UserPrimitives::occluded(const RTCOccludedFunctionNArguments* arguments) {
    const auto& self = *static_cast<const UserPrimitives*>(arguments->geometryUserPtr);
    const auto& query = *static_cast<const EmbreeQuery*>(arguments->context);
    const std::uint32_t id = self.ids_[arguments->primID];
    const bool hit = primitive_first_hit(self.scene_, id, query.query) <= query.query.ray.tmax;
    if (hit) single<RTCRay>(arguments->ray).tfar = -std::numeric_limits<float>::infinity();
    report(*arguments, hit);
}

}  // namespace etalon
