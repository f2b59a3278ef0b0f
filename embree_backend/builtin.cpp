#include "embree_backend/builtin.h"

#include <map>

#include "core/numerics/rounding.h"
#include "embree_backend/float_geometry.h"
#include "embree_backend/query.h"

namespace etalon {
namespace {

/// Returns the t from which a ray is tested. Rounded to floats, a surface lies off by about u (1 +
/// |o|) in the frame (0.6 of that was seen), so a ray that leaves it at an angle meets it again
/// before t = u (1 + |o|) / cosine. The margin clears all rays but those within 1/128 of tangent,
/// and loses contacts nearer than 1e-5 of the scene's size. Slivers are further off.
float first_t(const NormalizedRay& ray, double tmin) {
    constexpr float margin = 128 * unit_roundoff_f;
    const Vec3f& o = ray.origin;
    const float size = 1 + std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)});
    return ray.tmin(tmin) + margin * size;
}

}  // namespace

EmbreeBuiltin::EmbreeBuiltin(const Geometry& geometry, Traversal traversal)
    : Intersector(geometry),
      others_(geometry, *this),
      embree_scene_(rtcNewScene(device_.handle())) {
    device_.check();
    build_objects<EmbreeBuiltin>(traversal);
    if (traversal == Traversal::robust) {
        rtcSetSceneFlags(embree_scene_.get(), RTC_SCENE_FLAG_ROBUST);
    }
    const FloatGeometry floats(device_, geometry, scene_bounds().space);
    std::map<RTCGeometryType, std::vector<std::uint32_t>> by_type;
    std::vector<BoundedPrimitive> others;
    for (const BoundedPrimitive& p : take_bounded()) {
        if (const auto type = embree_type_of(geometry, scene_bounds().space, p.id)) {
            by_type[*type].push_back(p.id);
        } else {
            others.push_back(p);
        }
    }
    for (auto& [type, ids] : by_type) {
        const auto number = static_cast<unsigned>(ids_.size());
        rtcAttachGeometryByID(embree_scene_.get(), floats.make(type, ids).get(), number);
        ids_.emplace_back(std::move(ids));
    }
    others_.build(device_, embree_scene_.get(), static_cast<unsigned>(ids_.size()),
                  scene_bounds().space, std::move(others));
}

bool EmbreeBuiltin::has_own_kernels(const Geometry& geometry) {
    const SceneBounds bounds = SceneBounds::of(geometry);
    return std::ranges::any_of(bounds.bounded,
                               [&](const BoundedPrimitive& p) {
                                   return embree_type_of(geometry, bounds.space, p.id).has_value();
                               }) ||
           std::ranges::any_of(geometry.objects, has_own_kernels);
}

std::size_t EmbreeBuiltin::own_bytes() const {
    std::size_t tables = others_.memory_bytes();
    for (const PrimitiveIds& ids : ids_) tables += ids.memory_bytes();
    return device_.bytes() + tables;
}

void EmbreeBuiltin::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                                    NearestHit& nearest) const {
    RTCRayHit ray;
    set_ray(ray.ray, local, first_t(local, query.ray.tmin), local.tmax(nearest.t));
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    if (others_.empty()) {
        embree_intersect(embree_scene_.get(), ray);
    } else {
        others_.intersect(embree_scene_.get(), query, local, nearest, ray);
    }
    if (ray.hit.geomID >= ids_.size()) return;
    const double t = ray.ray.tfar / local.scale + local.shift;
    nearest.offer(std::min(t, nearest.t), ids_[ray.hit.geomID][ray.hit.primID]);
}

bool EmbreeBuiltin::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    const float tfar = local.tmax(query.ray.tmax);
    if (tfar < 0) return false;  // which is how Embree would tell that there is a hit
    RTCRay ray;
    set_ray(ray, local, first_t(local, query.ray.tmin), tfar);
    if (others_.empty()) {
        embree_occluded(embree_scene_.get(), ray);
    } else {
        others_.occluded(embree_scene_.get(), query, local, ray);
    }
    return ray.tfar < 0;
}

}  // namespace etalon
