#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/edges.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Corners as references into the geometry: a copy would cost a kernel as much as an edge function.
/// Decimal ones are decoded.
class TriangleCorners {
  public:
    TriangleCorners(const Geometry& geometry, const Triangle& t) {
        const auto [a, b, c] = t.vertices;
        if (((a | b | c) & decimal_vertex) == 0) {
            corners_ = {&geometry.vertices[a], &geometry.vertices[b], &geometry.vertices[c]};
        } else {
            decoded_ = {geometry.vertex(a), geometry.vertex(b), geometry.vertex(c)};
            corners_ = {&decoded_[0], &decoded_[1], &decoded_[2]};
        }
    }
    TriangleCorners(const TriangleCorners&) = delete;
    TriangleCorners& operator=(const TriangleCorners&) = delete;

    const Vec3& operator[](std::size_t k) const { return *corners_[k]; }

  private:
    std::array<const Vec3*, 3> corners_;
    std::array<Vec3, 3> decoded_;
};

inline std::array<Vec3, 3> corners(const Geometry& geometry, const Triangle& t) {
    const TriangleCorners p(geometry, t);
    return {p[0], p[1], p[2]};
}

inline Vec3 front_normal(const TriangleCorners& p) {
    return (p[1] - p[0]).cross(p[2] - p[0]);
}

inline Box3 bounds(const Geometry& geometry, const Triangle& t) {
    Box3 box;
    for (const Vec3& p : corners(geometry, t)) {
        if (!is_finite(p)) return {};
        box.extendBy(p);
    }
    return box;
}

/// Crossing of a ray and a triangle: barycentric weights times their sum, and the depths.
struct TriangleCrossing {
    std::array<double, 3> weight, depth;
    double sum;
    double error_bound;  ///< bound on the error of a weight

    bool is_inside() const {
        const auto [u, v, w] = weight;
        return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    }

    /// Returns whether the products of two weights' terms are in the range of double, with room for
    /// cancellation.
    bool is_in_range() const { return error_bound > 0x1p-500 && error_bound < 0x1p500; }
};

/// Computes those weights exactly whose sign their roundings could change. Computes all of them
/// exactly where the triangle is so thin or edge-on that they would mean little, or where products
/// leave the range of double; the largest weight is then about 1.
[[gnu::cold]] void finalize_weights(TriangleCrossing& c, const TriangleCorners& p,
                                    const RayQuery& q);

inline double max_abs(double x, double y, double z) {
    return std::max(std::abs(x), std::max(std::abs(y), std::abs(z)));
}

/// Returns whether a triangle is so thin or edge-on that its weights mean little.
inline bool is_thin(const TriangleCrossing& c) {
    return !(std::abs(c.sum) > 0x1p28 * c.error_bound);
}

/// Evaluates edge functions in double where their error bound allows it, exactly where not.
[[gnu::always_inline]] inline TriangleCrossing cross_triangle(const TriangleCorners& p,
                                                              const RayQuery& q) {
    const ShearedCorner a = shear(p[0], q), b = shear(p[1], q), c = shear(p[2], q);
    const double u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
    const double extent = std::max(max_abs(a.x, b.x, c.x), max_abs(a.y, b.y, c.y));
    const double error_bound = edge_error(extent, max_abs(a.z, b.z, c.z), q);
    TriangleCrossing r{{u, v, w}, {a.z, b.z, c.z}, u + v + w, error_bound};
    const double least = std::min({u, v, w}), most = std::max({u, v, w});
    const bool surely_outside = least < -error_bound && most > error_bound;
    const bool surely_inside = (least > error_bound || most < -error_bound) && !is_thin(r);
    if (!surely_inside && !surely_outside) finalize_weights(r, p, q);
    return r;
}

/// Returns the t at which the ray passes the plane of three corners, to t_tolerance; slow. The ray
/// must pass between them, and not along the plane.
double exact_distance(const TriangleCrossing& c, const TriangleCorners& p, const RayQuery& q);

/// Returns whether n . (p - o) and n . d, for the normal n = (b - a) x (c - a), surely are of
/// opposite signs: the plane is behind the ray's start, as that of a triangle which it has just
/// left. A component of n is off by 4 u of its two products, and the sums over f = p - o by 4 u
/// more, to first order.
inline bool is_plane_behind(const TriangleCorners& p, const RayQuery& q) {
    const Vec3 e = p[1] - p[0], g = p[2] - p[0], f = p[0] - q.ray.origin;
    const Vec3& d = q.ray.direction;
    Vec3 n, terms;
    for (int k = 0; k < 3; ++k) {
        const double plus = e[(k + 1) % 3] * g[(k + 2) % 3],
                     minus = e[(k + 2) % 3] * g[(k + 1) % 3];
        n[k] = plus - minus;
        terms[k] = std::abs(plus) + std::abs(minus);
    }
    const double distance = n.dot(f), approach = n.dot(d);
    const double error_bound = 10 * unit_roundoff, least = 0x1p-900;  // no product underflows
    return (distance < 0) != (approach < 0) &&
           std::abs(distance) > std::max(error_bound * terms.dot(abs(f)), least) &&
           std::abs(approach) > std::max(error_bound * terms.dot(abs(d)), least);
}

/// Returns the mean of the corners' depths. It is good to t_tolerance, or computed exactly, unless
/// it is certainly behind the ray's start.
inline double distance_of(const TriangleCrossing& c, const TriangleCorners& p, const RayQuery& q) {
    const auto [u, v, w] = c.weight;
    const auto [x, y, z] = c.depth;
    const double depth = (u * x + v * y + w * z) / c.sum, t = depth / q.dz;
    const double deepest = std::max({std::abs(x), std::abs(y), std::abs(z)});
    const double spread = std::max({x, y, z}) - std::min({x, y, z});
    const double error_bound =
        4 * c.error_bound / std::abs(c.sum) * spread + 8 * unit_roundoff * deepest;
    const bool good = error_bound <= t_tolerance * std::abs(depth);
    if (good || (t < 0 && std::abs(depth) > error_bound)) return t;
    if (is_plane_behind(p, q)) return no_hit;
    return exact_distance(c, p, q);
}

/// An edge belongs to the triangle; a ray in the triangle's plane misses.
inline double first_hit(const Geometry& geometry, const Triangle& tri, Sides sides,
                        const RayQuery& q) {
    const TriangleCorners p(geometry, tri);
    const TriangleCrossing c = cross_triangle(p, q);
    if (!c.is_inside() || c.sum == 0 || !faces(c.sum / q.dz, sides)) return no_hit;
    const double t = distance_of(c, p, q);
    return is_ahead(t, q.ray.tmin) ? t : no_hit;
}

/// The position is interpolated from the corners and so as exact as they are, however far the ray
/// came.
inline SurfacePoint surface(const Geometry& geometry, const Triangle& tri, const RayQuery& q,
                            double) {
    const TriangleCorners p(geometry, tri);
    TriangleCrossing c = cross_triangle(p, q);
    double sum = 0;
    for (double& w : c.weight) sum += w = std::max(0.0, c.sum < 0 ? -w : w);
    if (sum == 0) c.weight = {1, 1, 1}, sum = 3;
    for (double& w : c.weight) w /= sum;
    const auto& [u, v, w] = c.weight;

    const Vec3 normal = normalized(front_normal(p));
    Vec3 shading = normal;
    if (tri.normal_offset != no_index) {
        const auto corner = [&](std::size_t k) {
            return geometry.normals[Geometry::normal_number(tri, k)];
        };
        const Vec3 mean = u * corner(0) + v * corner(1) + w * corner(2);
        if (mean.dot(mean) > 0) shading = normalized(mean);
    }
    Box3 box;
    for (std::size_t k = 0; k < 3; ++k) box.extendBy(p[k]);
    const Vec3 magnitude(std::max(abs(box.min).x, abs(box.max).x),
                         std::max(abs(box.min).y, abs(box.max).y),
                         std::max(abs(box.min).z, abs(box.max).z));
    return {u * p[0] + v * p[1] + w * p[2], position_error(magnitude, max_abs(box.size())), normal,
            shading};
}

/// Returns pbrt's parametrization of a triangle without coordinates of its own: (0, 0), (1, 0) and
/// (1, 1) at the corners. dpdu x dpdv points where the normal does.
inline Parametrization parametrization(const Geometry& geometry, const Triangle& t,
                                       const SurfacePoint& p) {
    const TriangleCorners corner(geometry, t);
    const Vec3 a = corner[1] - corner[0], b = corner[2] - corner[0], w = p.position - corner[0];
    const Vec3 n = front_normal(corner);
    const int k = dominant_axis(n);
    // The second is derived from the first, so that together they give the point even where the
    // triangle is so thin that each is far off.
    const double weight2 = a.cross(w)[k] / n[k], weight1 = a.dot(w - weight2 * b) / a.dot(a);
    return {{saturated(weight1 + weight2), saturated(weight2)}, a, corner[2] - corner[1]};
}

}  // namespace etalon
