#include "embree_backend/plain_user_geometry.h"

#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/numerics/denormals.h"
#include "embree_backend/query.h"

namespace etalon {
namespace {

bool is_bounded(const Box3& box) {
    return !box.isEmpty() && is_finite(box.min) && is_finite(box.max);
}

/// Returns the boxes of all instances.
std::vector<Box3> boxes_of_instances(const Geometry& geometry) {
    Box3 others;
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        const Box3 box = primitive_bounds(geometry, id);
        if (is_bounded(box)) others.extendBy(box);
    }
    return instance_bounds(geometry, others);
}

/// Returns what SceneBounds::of does but for the bounded primitives, which Embree asks for by
/// number. It is worked out anew, one primitive after the other: see the class.
SceneBounds plain_bounds(const Geometry& geometry) {
    SceneBounds result;
    Box3 world;
    const auto add = [&](std::uint32_t item, const Box3& box) {
        if (is_bounded(box)) {
            world.extendBy(box);
        } else if (!box.isEmpty()) {
            result.unbounded.push_back(item);
        }
    };
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        add(id, primitive_bounds(geometry, id));
    }
    auto item = static_cast<std::uint32_t>(geometry.primitives.size());
    for (const Box3& box : boxes_of_instances(geometry)) add(item++, box);
    result.space = NormalizedSpace(world);
    return result;
}

/// Input of the callback for boxes, for as long as the scene is built.
struct BoundsQuery {
    const Geometry& geometry;
    const NormalizedSpace& space;
    std::vector<Box3> instances;

    Box3 box(std::uint32_t item) const {
        if (!geometry.is_instance(item)) return primitive_bounds(geometry, item);
        return instances[item - geometry.primitives.size()];
    }
};

/// Gives each box nine times the margin that NormalizedSpace::padding derives, roundings to float
/// included, so that an error in that derivation is no error here. Embree ignores a primitive whose
/// box is empty. Its builder flushes denormals to zero on the threads that call this.
void bounds_of_primitive(const RTCBoundsFunctionArguments* arguments) {
    constexpr double margin = 0x1p-16;
    const DenormalsCount denormals_count;
    const auto& data = *static_cast<const BoundsQuery*>(arguments->geometryUserPtr);
    const Box3 world = data.box(arguments->primID);
    Box3f box;
    if (is_bounded(world)) {
        box.min = Vec3f(data.space.point(world.min) - Vec3(margin));
        box.max = Vec3f(data.space.point(world.max) + Vec3(margin));
    }
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

/// Input of the callbacks for hits: Embree hands them the context it was given for the ray.
struct Query : EmbreeContext {
    Query(const Geometry& s, const Intersector& i, const RayQuery& q, const NormalizedRay& l,
          const NearestHit& n)
        : geometry(s), instances(i), query(q), local(l), nearest(n) {
        initialise(*this);
    }

    /// Offers what the kernel finds. True where that is no further away than the nearest so far.
    bool offer(std::uint32_t primitive) {
        if (geometry.is_instance(primitive)) {
            instances.offer_instance(primitive, query, nearest);
            return nearest.item == primitive;
        }
        const double t = primitive_first_hit(geometry, primitive, query);
        if (!(t <= nearest.t)) return false;
        nearest.offer(t, primitive);
        return true;
    }

    const Geometry& geometry;
    const Intersector& instances;
    const RayQuery& query;
    const NormalizedRay& local;
    NearestHit nearest;
};

/// Sets tfar to the nearest t rounded up, so that primitives at the same t are still offered.
/// Embree's layout of a packet of one ray is that of a single ray.
void intersect_primitive(const RTCIntersectFunctionNArguments* arguments) {
    auto& query = *static_cast<Query*>(arguments->context);
    const bool found = query.offer(arguments->primID);
    RTCRay& ray = reinterpret_cast<RTCRayHit*>(arguments->rayhit)->ray;
    if (found) ray.tfar = query.local.tmax(query.nearest.t);
    report(*arguments, found);
}

/// Sets tfar to what tells Embree to stop.
void occluded_by_primitive(const RTCOccludedFunctionNArguments* arguments) {
    auto& query = *static_cast<Query*>(arguments->context);
    const bool found = query.offer(arguments->primID);
    RTCRay& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
    if (found) ray.tfar = -std::numeric_limits<float>::infinity();
    report(*arguments, found);
}

}  // namespace

/// A primitive's number in the geometry is its number in the scene. RTC_SCENE_FLAG_ROBUST is left
/// out: Embree's traversal of user geometries takes no notice of it.
PlainUserGeometry::PlainUserGeometry(const Geometry& geometry)
    : Intersector(geometry, plain_bounds(geometry)), embree_scene_(rtcNewScene(device_.handle())) {
    build_objects<PlainUserGeometry>();
    const EmbreeOwned<RTCGeometry> owned(rtcNewGeometry(device_.handle(), RTC_GEOMETRY_TYPE_USER));
    device_.check();
    RTCGeometry primitives = owned.get();
    BoundsQuery data{geometry, scene_bounds().space, boxes_of_instances(geometry)};
    rtcSetGeometryUserPrimitiveCount(primitives, geometry.item_count());
    rtcSetGeometryUserData(primitives, &data);
    rtcSetGeometryBoundsFunction(primitives, bounds_of_primitive, nullptr);
    rtcSetGeometryIntersectFunction(primitives, intersect_primitive);
    rtcSetGeometryOccludedFunction(primitives, occluded_by_primitive);
    rtcCommitGeometry(primitives);
    rtcAttachGeometry(embree_scene_.get(), primitives);
    device_.commit(embree_scene_.get());
}

void PlainUserGeometry::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                                        NearestHit& nearest) const {
    Query context(geometry(), *this, query, local, nearest);
    RTCRayHit ray;
    set_ray(ray.ray, local, local.tmin(query.ray.tmin), local.tmax(nearest.t));
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree_intersect(embree_scene_.get(), context, ray);
    nearest = context.nearest;
}

bool PlainUserGeometry::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    Query context(geometry(), *this, query, local, NearestHit(query.ray.tmax));
    RTCRay ray;
    set_ray(ray, local, local.tmin(query.ray.tmin), local.tmax(query.ray.tmax));
    embree_occluded(embree_scene_.get(), context, ray);
    return context.nearest.found();
}

}  // namespace etalon
