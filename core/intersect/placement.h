// The way between the world and the objects of instances: all that knows of it is here.
#pragma once

#include <optional>

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// An instance where a ray of some time sees it: of one that moves, what its motion's map at that
/// time makes of it.
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

/// Takes a vector of the world into the object's space.
inline Vec3 vector_to_object(const Instance& instance, const Vec3& v) {
    return {instance.rows[0].dot(v), instance.rows[1].dot(v), instance.rows[2].dot(v)};
}

/// Takes a point of the world into the object's space.
inline Vec3 to_object(const Instance& instance, const Vec3& point) {
    return vector_to_object(instance, point - instance.origin);
}

/// Takes a ray into the object's space. This defines what is hit of an instance: that which the
/// ray returned here hits of the object. Its t is the world's, as its direction is not normalized.
/// No primitive is excluded from it.
inline Ray to_object(const Instance& instance, const Ray& ray) {
    Ray local{to_object(instance, ray.origin), vector_to_object(instance, ray.direction), ray.tmin,
              ray.tmax};
    local.traits_and_time = ray.traits_and_time;
    return local;
}

/// A bound on |A^-1| |A| v, where A is the instance's matrix and v has three components 1: how far
/// a relative error of a point in the object's space moves it in the world, for each axis.
Vec3 spread(const Instance& instance);

/// Takes a point of the object's surface into the world. Its error is such that a ray which leaves
/// the point starts off the object's surface after all roundings on its way into the object.
SurfacePoint placed(const Instance& instance, const SurfacePoint& local);

/// Bounds how far, for each axis of the object's space, the origin of a ray that leaves `world` is
/// from the point `local` that was placed there, once it is back in that space.
Vec3 drift_of_origins(const Instance& instance, const SurfacePoint& local,
                      const SurfacePoint& world);

/// Returns a point of an instance as the object's shape has it; it has no error bound.
SurfacePoint local_point(const Instance& instance, const SurfacePoint& point);

/// Takes coordinates of an object's surface into the world.
Parametrization placed(const Instance& instance, const Parametrization& local);

/// Calls the kernel of a primitive, or of one of an instance, for a ray of the world.
double first_hit(const Geometry& geometry, HitKey key, const Ray& ray);

}  // namespace etalon
