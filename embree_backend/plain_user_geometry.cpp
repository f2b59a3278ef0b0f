#include "embree_backend/plain_user_geometry.h"

#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/intersect/near_region.h"
#include "core/intersect/outliers.h"
#include "core/numerics/denormals.h"
#include "embree_backend/query.h"

namespace etalon {
namespace {

/// Computes the boxes of all items, one primitive after the other: see PlainUserGeometry.
class PlainBoxes {
  public:
    explicit PlainBoxes(const Geometry& geometry)
        : geometry_(geometry), near_{middle_of(geometry)} {
        instances_ = boxes_of_instances();
        ReachCounts reaches;
        for (std::uint32_t item = 0; item < geometry.item_count(); ++item) {
            if (!is_near(item)) continue;
            const Box3 bounds = box(item);
            reaches.add(near_.reach_of(bounds), max_abs(bounds.size()), geometry.is_instance(item));
        }
        near_.reach = reaches.limit(OutlierRule::cost);
        if (!near_.is_everything()) instances_ = boxes_of_instances();
    }

    Box3 box(std::uint32_t item) const {
        if (!geometry_.is_instance(item)) return whole_bounds(geometry_, item);
        return instances_[item - geometry_.primitives.size()];
    }

    bool is_near(std::uint32_t item) const { return near_.contains(box(item)); }

  private:
    LargeVector<Box3> boxes_of_instances() const {
        Box3 others;
        for (std::uint32_t id = 0; id < geometry_.primitives.size(); ++id) {
            if (is_near(id)) others.extendBy(whole_bounds(geometry_, id));
        }
        return instance_bounds(geometry_, others, near_).boxes;
    }

    const Geometry& geometry_;
    NearRegion near_;
    LargeVector<Box3> instances_;
};

/// Returns what SceneBounds::of does, except for the bounded primitives: Embree asks for these by
/// number.
SceneBounds plain_bounds(const Geometry& geometry) {
    const PlainBoxes boxes(geometry);
    SceneBounds result;
    Box3 world;
    for (std::uint32_t item = 0; item < geometry.item_count(); ++item) {
        if (boxes.is_near(item)) {
            world.extendBy(boxes.box(item));
        } else if (!boxes.box(item).isEmpty()) {
            result.unbounded.push_back(item);
        }
    }
    result.space = NormalizedSpace(world);
    result.separate_far(geometry);
    return result;
}

/// Input of the callback for boxes while the scene is built.
struct BoundsQuery {
    PlainBoxes boxes;
    const NormalizedSpace& space;
};

/// Gives each box nine times the margin that NormalizedSpace::padding derives, roundings to float
/// included, so that an error in that derivation has no effect here. Embree ignores a primitive
/// whose box is empty. Its builder flushes denormals to zero on the threads that call this.
void bounds_of_primitive(const RTCBoundsFunctionArguments* arguments) {
    constexpr double margin = 0x1p-16;
    const DenormalsCount denormals_count;
    const auto& data = *static_cast<const BoundsQuery*>(arguments->geometryUserPtr);
    Box3f box;
    if (data.boxes.is_near(arguments->primID)) {
        const Box3 world = data.boxes.box(arguments->primID);
        box.min = Vec3f(data.space.point(world.min) - Vec3(margin));
        box.max = Vec3f(data.space.point(world.max) + Vec3(margin));
    }
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
}

/// Input of the callbacks for hits: Embree passes them the context of the ray.
struct Query : EmbreeContext {
    Query(const Geometry& s, const Intersector& i, const RayQuery& q, const NormalizedRay& l,
          const NearestHit& n)
        : geometry(s), instances(i), query(q), local(l), nearest(n) {
        initialise(*this);
    }

    /// Offers what the kernel finds. Returns whether that is no further away than the nearest so
    /// far.
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

/// Sets tfar to the value that tells Embree to stop.
void occluded_by_primitive(const RTCOccludedFunctionNArguments* arguments) {
    auto& query = *static_cast<Query*>(arguments->context);
    const bool found = query.offer(arguments->primID);
    RTCRay& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
    if (found) ray.tfar = -std::numeric_limits<float>::infinity();
    report(*arguments, found);
}

}  // namespace

/// A primitive's number in the geometry is its number in the scene. RTC_SCENE_FLAG_ROBUST is not
/// set: Embree's traversal of user geometries ignores it.
PlainUserGeometry::PlainUserGeometry(const Geometry& geometry, const SceneDevice* of_scene)
    : Intersector(geometry, plain_bounds(geometry)),
      device_(of_scene),
      embree_scene_(rtcNewScene(device_->handle())) {
    build_objects<PlainUserGeometry>(&device_);
    const EmbreeOwned<RTCGeometry> owned(rtcNewGeometry(device_->handle(), RTC_GEOMETRY_TYPE_USER));
    device_->check();
    RTCGeometry primitives = owned.get();
    BoundsQuery data{PlainBoxes(geometry), scene_bounds().space};
    rtcSetGeometryUserPrimitiveCount(primitives, geometry.item_count());
    rtcSetGeometryUserData(primitives, &data);
    rtcSetGeometryBoundsFunction(primitives, bounds_of_primitive, nullptr);
    rtcSetGeometryIntersectFunction(primitives, intersect_primitive);
    rtcSetGeometryOccludedFunction(primitives, occluded_by_primitive);
    rtcCommitGeometry(primitives);
    rtcAttachGeometry(embree_scene_.get(), primitives);
    device_->commit(embree_scene_.get());
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
