// Transforms between world space and the object space of instances: all code for them is here.
#pragma once

#include <optional>

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// An instance at the time of a ray. A moving instance is replaced by the still one that its
/// animated transform gives for that time.
class InstanceAt {
  public:
    /// `number` is among the geometry's instances. The geometry must outlive this.
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

/// Transforms a ray from world to the object space of an instance of that number. This defines what
/// a ray hits of an instance: what the returned ray hits of the object. Its direction is not
/// normalized, so that t is the same in both spaces.
inline Ray to_object(const Instance& instance, std::uint32_t number, const Ray& ray) {
    return {to_object(instance, ray.origin),
            vector_to_object(instance, ray.direction),
            ray.tmin,
            ray.tmax,
            ray.excluded(number),
            ray.traits_and_time};
}

/// Transforms a normal from object to world space; its length changes.
inline Vec3 normal_to_world(const Instance& instance, const Vec3& n) {
    return n.x * instance.rows[0] + n.y * instance.rows[1] + n.z * instance.rows[2];
}

/// Returns a bound on |A^-1| |A| v for each axis, where A is the instance's matrix and v has three
/// components 1: the factor by which a relative error of a point in object space grows in world
/// space. `to_world` is that of the instance.
Vec3 spread(const Instance& instance, const Affine& to_world);

/// Transforms a point of the object's surface to world space. Its error bound is so large that a
/// ray which leaves it still starts off the object's surface after all roundings of its transform
/// to object space.
SurfacePoint placed(const Instance& instance, const SurfacePoint& local);

/// Returns a bound, for each axis of object space, on the distance between the point `local` and
/// the origin of a ray that leaves `world`, once that is transformed back. `world` is `local` in
/// world space.
Vec3 drift_of_origins(const Instance& instance, const SurfacePoint& local,
                      const SurfacePoint& world);

/// Transforms a point of an instance to object space; the result has no error bound.
SurfacePoint local_point(const Instance& instance, const SurfacePoint& point);

/// Transforms the derivatives of a point of the object's surface to world space.
Parametrization placed(const Instance& instance, const Parametrization& local);

/// Calls the kernel of a primitive, of the scene or of an instance, for a ray in world space.
double first_hit(const Geometry& geometry, HitKey key, const Ray& ray);

}  // namespace etalon
