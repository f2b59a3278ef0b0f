// Transforms between world space and the object space of instances: all of them are here.
#pragma once

#include <optional>

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// An instance at the time of a ray: a moving one is replaced by the still one that its animated
/// transform gives for that time.
class InstanceAt {
  public:
    /// `number`: among the geometry's instances. The geometry must outlive it.
    InstanceAt(const Geometry& geometry, std::uint32_t number, ShutterTime time)
        : instance_(&geometry.instances[number]) {
        if (instance_->moves()) [[unlikely]]
            move(geometry, time);
    }
    InstanceAt(const InstanceAt&) = delete;
    InstanceAt& operator=(const InstanceAt&) = delete;

    const Instance& operator*() const { return *instance_; }
    const Instance* operator->() const { return instance_; }

  private:
    void move(const Geometry& geometry, ShutterTime time);

    const Instance* instance_;
    std::optional<Instance> moved_;
};

/// Transforms a vector from world to object space.
inline Vec3 vector_to_object(const Instance& instance, const Vec3& v) {
    return {instance.rows[0].dot(v), instance.rows[1].dot(v), instance.rows[2].dot(v)};
}

/// Transforms a point from world to object space.
inline Vec3 to_object(const Instance& instance, const Vec3& point) {
    return vector_to_object(instance, point - instance.origin);
}

/// Transforms a ray from world to object space. This defines what is hit of an instance: what the
/// ray returned here hits of the object. Its direction is not normalized, so its t is that of the
/// world. It excludes no primitive.
inline Ray to_object(const Instance& instance, const Ray& ray) {
    Ray local{to_object(instance, ray.origin), vector_to_object(instance, ray.direction), ray.tmin,
              ray.tmax};
    local.traits_and_time = ray.traits_and_time;
    return local;
}

/// A bound on |A^-1| |A| v, where A is the instance's matrix and v has three components 1: how far
/// a relative error of a point in the object's space moves it in the world, for each axis.
Vec3 spread(const Instance& instance);

/// Transforms a point of the object's surface to world space. Its error bound is such that a ray
/// which leaves it starts off the object's surface after all roundings on its way back there.
SurfacePoint placed(const Instance& instance, const SurfacePoint& local);

/// Bounds how far, for each axis of the object's space, the origin of a ray that leaves `world` is
/// from the point `local` that was placed there, once it is back in that space.
Vec3 drift_of_origins(const Instance& instance, const SurfacePoint& local,
                      const SurfacePoint& world);

/// Transforms a point of an instance to object space; the result has no error bound.
SurfacePoint local_point(const Instance& instance, const SurfacePoint& point);

/// Transforms coordinates of an object's surface to world space.
Parametrization placed(const Instance& instance, const Parametrization& local);

/// Calls the kernel of a primitive, or of one of an instance, for a ray in world space.
double first_hit(const Geometry& geometry, HitKey key, const Ray& ray);

}  // namespace etalon
