#include "core/camera/lens_tracer.h"

#include <algorithm>
#include <cmath>

namespace etalon {
namespace {

/// Returns the direction behind a surface with the unit normal `n` on the side of the incoming ray;
/// `eta` is the index on that side over the other. Nothing for total reflection.
std::optional<Vec3> refracted(const Vec3& direction, const Vec3& n, double eta) {
    const double cosine = -n.dot(direction);
    const double sine2 = eta * eta * std::max(0.0, 1 - cosine * cosine);
    if (sine2 >= 1) return std::nullopt;
    return eta * direction + (eta * cosine - std::sqrt(1 - sine2)) * n;
}

}  // namespace

LensTracer::LensTracer(std::span<const LensSurface> surfaces)
    : rear_radius_(surfaces.back().aperture_radius) {
    double z = 0;
    for (const LensSurface& s : surfaces) z += s.thickness;
    double eta_front = 1;
    for (const LensSurface& s : surfaces) {
        const double eta_rear = s.eta != 0 ? s.eta : 1;
        surfaces_.push_back(
            {z, s.curvature_radius, s.aperture_radius * s.aperture_radius, eta_front, eta_rear});
        eta_front = eta_rear;
        z -= s.thickness;
    }
}

bool LensTracer::pass(const Surface& s, bool to_scene, LensRay& ray) {
    if (s.curvature_radius == 0) {
        if ((ray.direction.z > 0) != to_scene) return false;
        ray.origin += (s.z - ray.origin.z) / ray.direction.z * ray.direction;
        return ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y <= s.aperture2;
    }
    const Vec3 centre(0, 0, s.z - s.curvature_radius), o = ray.origin - centre;
    const Vec3 d = normalized(ray.direction);
    const double b = o.dot(d), c = o.dot(o) - s.curvature_radius * s.curvature_radius;
    const double discriminant = b * b - c;
    if (discriminant < 0) return false;
    const bool nearer = (s.curvature_radius > 0) != (d.z > 0);
    const double root = std::sqrt(discriminant), t = nearer ? -b - root : -b + root;
    if (t < 0) return false;
    ray.origin += t * d;
    if (ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y > s.aperture2) return false;
    Vec3 normal = (ray.origin - centre) / std::abs(s.curvature_radius);
    if (normal.dot(d) > 0) normal = -normal;
    const double eta = to_scene ? s.eta_rear / s.eta_front : s.eta_front / s.eta_rear;
    const std::optional<Vec3> direction = refracted(d, normal, eta);
    if (!direction) return false;
    ray.direction = *direction;
    return true;
}

std::optional<LensRay> LensTracer::from_film(LensRay ray) const {
    for (auto s = surfaces_.rbegin(); s != surfaces_.rend(); ++s) {
        if (!pass(*s, true, ray)) return std::nullopt;
    }
    return ray;
}

std::optional<LensRay> LensTracer::from_scene(LensRay ray) const {
    for (const Surface& s : surfaces_) {
        if (!pass(s, false, ray)) return std::nullopt;
    }
    return ray;
}

}  // namespace etalon
