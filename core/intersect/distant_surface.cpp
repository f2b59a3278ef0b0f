#include "core/intersect/distant_surface.h"

#include "core/intersect/shapes/all_shapes.h"
#include "core/numerics/dyadic_vec.h"

namespace etalon {
namespace {

Vec3 centre_of(const Sphere& s) {
    return s.centre;
}
Vec3 centre_of(const Cone& c) {
    return c.base;
}
Vec3 centre_of(const Quadric& q) {
    return q.centre;
}
template <class Image>
Vec3 centre_of(const Image& image) {
    return image.to_world.origin;
}

/// Return the shape with its centre moved to the origin.
Sphere centred(const Sphere& s) {
    return {Vec3(0), s.radius};
}
Cone centred(const Cone& c) {
    return {Vec3(0), c.top - c.base, c.base_radius, c.top_radius};
}
Quadric centred(const Quadric& q) {
    return {Vec3(0), q.coefficients, {q.clip.min - q.centre, q.clip.max - q.centre}};
}
Affine centred(const Affine& map) {
    return {map.x, map.y, map.z, Vec3(0)};
}
Revolved centred(const Revolved& s) {
    return s.under(centred(s.to_world));
}
template <class Image>
Image centred(const Image& image) {
    return Image(centred(image.to_world));
}

/// Returns the point of a ray's line nearest to `centre`, relative to it: d x ((o - c) x d) over
/// the square of d. The inner product, in which everything cancels, is exact.
Vec3 nearest_point(const Ray& ray, const Vec3& centre) {
    const Vec3 d = to_unit_magnitude(ray.direction);
    const DyadicVec moment = cross(difference(ray.origin, centre), exactly(d));
    return d.cross({moment[0].rounded(), moment[1].rounded(), moment[2].rounded()}) / d.dot(d);
}

/// A ray moved along its line to start before a shape, which is moved to the origin.
template <class Shape>
struct RayNearby {
    RayNearby(const Geometry& of, const Shape& s, Sides visible, const Ray& from)
        : geometry(of), shape(centred(s)), sides(visible), centre(centre_of(s)) {
        const Box3 box = bounds(geometry, shape);
        before = 2 * (sum_abs(box.min) + sum_abs(box.max));
        ray.direction = unit_vector(from.direction);
        ray.origin = nearest_point(from, centre) - before * ray.direction;
    }

    double first_hit_after(double tmin) {
        ray.tmin = tmin;
        return first_hit(geometry, shape, sides, RayQuery(ray));
    }

    /// Returns where the hit at `t` of the original ray is. That is the first hit, unless the
    /// original ray starts there or further on, as in a shape that is much longer than thick: then
    /// of two hits it is the nearer one, as far as roundings allow.
    double place_of(const Ray& from, double t) {
        const double first = first_hit_after(0);
        if (!(first < infinity)) return before;  // at a silhouette
        const bool starts_there = from.tmin > t / 2 || first < place_along(from, from.tmin);
        if (!starts_there) return first;
        const double second = first_hit_after(first);
        const double about = place_along(from, t);
        return std::abs(second - about) < std::abs(first - about) ? second : first;
    }

    /// Returns where the point at `t` of the original ray is, but for roundings.
    double place_along(const Ray& from, double t) const {
        return before + (from.origin - centre + t * from.direction).dot(ray.direction);
    }

    const Geometry& geometry;
    Shape shape;
    Sides sides;
    Vec3 centre;
    double before;  ///< t of the point nearest to the centre
    Ray ray;
};

}  // namespace

template <HasThickness Shape>
SurfacePoint distant_surface(const Geometry& geometry, const Shape& shape, Sides sides,
                             const Ray& ray, double t) {
    RayNearby<Shape> nearby(geometry, shape, sides, ray);
    const double place = nearby.place_of(ray, t);
    SurfacePoint p = surface(geometry, nearby.shape, RayQuery(nearby.ray), place);
    p.position += nearby.centre;
    p.error += position_error(abs(nearby.centre), 0);
    if (!is_finite(p.normal)) p.normal = p.shading_normal = -nearby.ray.direction;
    return p;
}

template SurfacePoint distant_surface(const Geometry&, const Sphere&, Sides, const Ray&, double);
template SurfacePoint distant_surface(const Geometry&, const Cone&, Sides, const Ray&, double);
template SurfacePoint distant_surface(const Geometry&, const Quadric&, Sides, const Ray&, double);
template SurfacePoint distant_surface(const Geometry&, const Ellipsoid&, Sides, const Ray&, double);
template SurfacePoint distant_surface(const Geometry&, const ClosedCylinder&, Sides, const Ray&,
                                      double);
template SurfacePoint distant_surface(const Geometry&, const Revolved&, Sides, const Ray&, double);

}  // namespace etalon
