#include "embree_backend/user_geometry.h"

#include "embree_backend/query.h"

namespace etalon {

EmbreeUserGeometry::EmbreeUserGeometry(const Geometry& geometry, const SceneDevice* of_scene)
    : Intersector(geometry),
      device_(of_scene),
      primitives_(geometry, *this, &objects_),
      embree_scene_(rtcNewScene(device_->handle())) {
    device_->check();
    build_objects<EmbreeUserGeometry>(&device_);
    for (std::uint32_t i = 0; i < geometry.objects.size(); ++i) {
        objects_.push_back(static_cast<const EmbreeUserGeometry&>(object(i)).primitives_.view());
    }
    primitives_.build(*device_, embree_scene_.get(), scene_bounds().space, take_bounded());
}

std::size_t EmbreeUserGeometry::own_bytes() const {
    return device_.bytes() + primitives_.memory_bytes() + objects_.capacity() * sizeof(UserView);
}

void EmbreeUserGeometry::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                                         NearestHit& nearest) const {
    RTCRayHit ray;
    set_ray(ray.ray, local, local.tmin(query.ray.tmin), local.tmax(nearest.t));
    primitives_.intersect(query, local, nearest, ray);
}

bool EmbreeUserGeometry::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    RTCRay ray;
    if (!set_occlusion_ray(ray, local, local.tmin(query.ray.tmin), local.tmax(query.ray.tmax))) {
        return false;
    }
    primitives_.occluded(query, local, ray);
    return ray.tfar < 0;
}

}  // namespace etalon
