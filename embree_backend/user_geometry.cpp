#include "embree_backend/user_geometry.h"

#include "embree_backend/query.h"

namespace etalon {

EmbreeUserGeometry::EmbreeUserGeometry(const Geometry& geometry)
    : Intersector(geometry),
      primitives_(geometry, *this),
      embree_scene_(rtcNewScene(device_.handle())) {
    device_.check();
    build_objects<EmbreeUserGeometry>();
    primitives_.build(device_, embree_scene_.get(), 0, scene_bounds().space, take_bounded());
}

std::size_t EmbreeUserGeometry::own_bytes() const {
    return device_.bytes() + primitives_.memory_bytes();
}

void EmbreeUserGeometry::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                                         NearestHit& nearest) const {
    RTCRayHit ray;
    set_ray(ray.ray, local, local.tmin(query.ray.tmin), local.tmax(nearest.t));
    primitives_.intersect(embree_scene_.get(), query, local, nearest, ray);
}

bool EmbreeUserGeometry::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    const float tfar = local.tmax(query.ray.tmax);
    if (tfar < 0) return false;  // Embree reports a hit by a negative tfar
    RTCRay ray;
    set_ray(ray, local, local.tmin(query.ray.tmin), tfar);
    primitives_.occluded(embree_scene_.get(), query, local, ray);
    return ray.tfar < 0;
}

}  // namespace etalon
