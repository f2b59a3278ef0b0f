#pragma once

#include <array>

#include "bench/accuracy/textbook/kernel.h"
#include "core/intersect/shapes/triangle.h"

namespace etalon::accuracy {

/// Möller & Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1), without its
/// epsilon, which is a length and so right at one size only.
template <class Real>
struct MollerTrumbore {
    using RayForm = PlainRay<Real>;

    MollerTrumbore(const Scene& scene, const Triangle& t) {
        const auto p = corners(scene.geometry, t);
        corner = Vec<Real>(p[0]);
        edge1 = Vec<Real>(p[1]) - corner;
        edge2 = Vec<Real>(p[2]) - corner;
    }

    Real first_hit(const RayForm& ray) const {
        const Vec<Real> p = ray.direction.cross(edge2);
        const Real determinant = edge1.dot(p);
        if (determinant == 0) return no_root<Real>;
        const Real inverse = 1 / determinant;
        const Vec<Real> s = ray.origin - corner;
        const Real u = s.dot(p) * inverse;
        if (u < 0 || u > 1) return no_root<Real>;
        const Vec<Real> q = s.cross(edge1);
        const Real v = ray.direction.dot(q) * inverse;
        if (v < 0 || u + v > 1) return no_root<Real>;
        const Real t = edge2.dot(q) * inverse;
        return contains(ray, t) ? t : no_root<Real>;
    }

    Vec<Real> corner, edge1, edge2;
};

/// Woop, Benthin & Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1): the corners
/// sheared into the ray's frame, and edges that come out as zero in float decided in double.
struct WatertightTriangle {
    using RayForm = PreparedRay;

    WatertightTriangle(const Scene& scene, const Triangle& t) {
        const auto p = corners(scene.geometry, t);
        for (int k = 0; k < 3; ++k) corner[k] = Vec3f(p[k]);
    }

    float first_hit(const PreparedRay& ray) const {
        const Vec3f a = sheared(corner[0], ray), b = sheared(corner[1], ray),
                    c = sheared(corner[2], ray);
        float u = edge(c, b), v = edge(a, c), w = edge(b, a);
        if (u == 0 || v == 0 || w == 0) {
            u = edge_in_double(c, b), v = edge_in_double(a, c), w = edge_in_double(b, a);
        }
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return no_root<float>;
        const float determinant = u + v + w;
        if (determinant == 0) return no_root<float>;
        const float t = (u * a.z + v * b.z + w * c.z) / determinant;
        return contains(ray, t) ? t : no_root<float>;
    }

    static Vec3f sheared(const Vec3f& p, const PreparedRay& ray) {
        const float x = p[ray.kx] - ray.origin[ray.kx];
        const float y = p[ray.ky] - ray.origin[ray.ky];
        const float z = p[ray.kz] - ray.origin[ray.kz];
        return {x - ray.shear.x * z, y - ray.shear.y * z, ray.shear.z * z};
    }
    static float edge(const Vec3f& p, const Vec3f& q) { return p.x * q.y - p.y * q.x; }
    static float edge_in_double(const Vec3f& p, const Vec3f& q) {
        return static_cast<float>(static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x);
    }

    std::array<Vec3f, 3> corner;
};

inline auto textbook_kernels(const Scene& scene, const Triangle& t) {
    return std::tuple{Named{"float Möller-Trumbore", MollerTrumbore<float>(scene, t)},
                      Named{"float Woop", WatertightTriangle(scene, t)},
                      Named{"double Möller-Trumbore", MollerTrumbore<double>(scene, t)}};
}

}  // namespace etalon::accuracy
