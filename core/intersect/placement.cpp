#include "core/intersect/placement.h"

#include "core/intersect/kernels.h"
#include "core/intersect/rescaled_ray.h"

namespace etalon {
namespace {

Vec3 times_magnitudes(const std::array<Vec3, 3>& rows, const Vec3& v) {
    return {abs(rows[0]).dot(v), abs(rows[1]).dot(v), abs(rows[2]).dot(v)};
}

/// Returns a bound on the roundings of transforming a point p to object space: see placed().
Vec3 roundings_from(const Instance& instance, const Vec3& p) {
    return 8 * unit_roundoff * times_magnitudes(instance.rows, abs(p) + abs(instance.origin));
}

}  // namespace

void InstanceAt::move(const Geometry& geometry, ShutterTime time) {
    const AnimatedTransform& motion = geometry.motions[instance_->motion];
    if (motion.is_translation()) {
        moved_ = *instance_;
        moved_->origin = motion.origin_at(time);
    } else {
        moved_.emplace(motion.at(time), instance_->object);
    }
    instance_ = &*moved_;
}

Vec3 spread(const Instance& instance, const Affine& to_world) {
    const Vec3 once = times_magnitudes(instance.rows, Vec3(1));
    const auto& [x, y, z, origin] = to_world;
    return once.x * abs(x) + once.y * abs(y) + once.z * abs(z);
}

/// The point is corrected once; its remaining error in object space is measured. A ray that leaves
/// it returns to object space with at most 8 roundings of |A| (|p| + |c|): one each for the point,
/// the spawned origin and the difference p - c, and five for the product with A. All of this is
/// projected on the object's normal n. A step along the world's normal A^T n / |A^T n| moves by
/// |A^T n| times its length along n.
SurfacePoint placed(const Instance& instance, const SurfacePoint& local) {
    const Affine map = instance.to_world();
    SurfacePoint p = local;
    p.position = map.point(local.position);
    p.position += map.vector(local.position - to_object(instance, p.position));
    const Vec3 residual = abs(local.position - to_object(instance, p.position));
    const Vec3 roundings = roundings_from(instance, p.position);
    const Vec3 across = normal_to_world(instance, local.normal);
    p.normal = normalized(across);
    p.shading_normal = normalized(normal_to_world(instance, local.shading_normal));
    const double clearance =
        abs(local.normal).dot(local.error + residual + roundings) / across.dot(p.normal);
    p.error = clearance * abs(p.normal);  // its product with the normal is the clearance
    if (p.convexity != Convexity::flat) p.convexity = Convexity::any;
    return p;
}

/// The origin is offset along the normal by the error: see spawn_origin(). Twice the sum leaves
/// room for the different errors of another point next to `local`.
Vec3 drift_of_origins(const Instance& instance, const SurfacePoint& local,
                      const SurfacePoint& world) {
    const Vec3 residual = abs(local.position - to_object(instance, world.position));
    return 2.0 * (residual + roundings_from(instance, world.position) +
                  times_magnitudes(instance.rows, world.error));
}

SurfacePoint local_point(const Instance& instance, const SurfacePoint& point) {
    const Affine map = instance.to_world();
    const auto back = [&](const Vec3& n) {
        return normalized(Vec3(map.x.dot(n), map.y.dot(n), map.z.dot(n)));
    };
    SurfacePoint local = point;
    local.position = to_object(instance, point.position);
    local.error = Vec3(0);
    local.normal = back(point.normal);
    local.shading_normal = back(point.shading_normal);
    local.instance = no_index;
    return local;
}

Parametrization placed(const Instance& instance, const Parametrization& local) {
    const Affine map = instance.to_world();
    return {local.uv, map.vector(local.dpdu), map.vector(local.dpdv)};
}

double first_hit(const Geometry& geometry, HitKey key, const Ray& ray) {
    if (!is_valid(ray)) return no_hit;
    if (has_extreme_direction(ray)) {
        const RescaledRay usual(ray);
        return first_hit(geometry, key, usual.ray) * usual.unit;
    }
    const std::uint32_t instance = static_cast<std::uint32_t>(key >> 32) - 1;
    const auto primitive = static_cast<std::uint32_t>(key);
    const Geometry& holder = geometry.holder(instance);
    const RayQuery query(ray);
    if (instance == no_index) return primitive_first_hit(holder, primitive, query);
    const InstanceAt at(geometry, instance, ray.time());
    return primitive_first_hit(holder, primitive, RayQuery(to_object(*at, instance, query.ray)));
}

}  // namespace etalon
