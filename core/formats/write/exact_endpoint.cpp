#include "core/formats/write/exact_endpoint.h"

#include <cmath>

#include "core/formats/polygon_normal.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// Edges (p, 0, -q) and (0, r, -s) along the axes i, j, k have the cross product (q r, p s, p r).
/// It must equal the normal, roundings included, which determines all for a given p; k is the
/// normal's largest component.
struct Edges {
    Vec3 first{0}, second{0};
};

Edges edges_across(const Vec3& normal, double p) {
    const int k = dominant_axis(normal), i = (k + 1) % 3, j = (k + 2) % 3;
    const double r = normal[k] / p;
    Edges e;
    e.first[i] = p;
    e.first[k] = -normal[i] / r;
    e.second[j] = r;
    e.second[k] = -normal[j] / p;
    return e;
}

/// Returns the power of two by which an edge becomes so long that no coordinate that it changes
/// loses digits of the edge to those of `start`.
double stretch_of(const Vec3& start, const Vec3& edge) {
    double stretch = 1;
    for (int k = 0; k < 3; ++k) {
        if (edge[k] == 0 || start[k] == 0) continue;
        const int ratio = std::ilogb(start[k]) - std::ilogb(edge[k]);
        stretch = std::max(stretch, std::ldexp(1.0, std::min(ratio + 2, 900)));
    }
    return stretch;
}

PlanePoints points_by(const Plane& plane, double p) {
    const Vec3& start = plane.point;
    const auto end = [&](const Vec3& edge) {
        return exact_endpoint(start, edge * stretch_of(start, edge)).point;
    };
    const Edges edges = edges_across(to_unit_magnitude(plane.normal), p);
    PlanePoints result{{start, end(edges.first), end(edges.second)}, false};
    const Vec3 normal = area_normal(result.points);
    result.exact = to_unit_magnitude(normal) == to_unit_magnitude(plane.normal);
    return result;
}

}  // namespace

ExactEndpoint exact_endpoint(const Vec3& start, const Vec3& edge) {
    ExactEndpoint end{start + edge, true};
    for (int k = 0; k < 3; ++k) {
        const double sum = end.point[k];
        const auto fits = [&](double x) { return x - start[k] == edge[k]; };
        if (fits(sum)) continue;
        const double above = std::nextafter(sum, infinity), below = std::nextafter(sum, -infinity);
        end.exact = end.exact && (fits(above) || fits(below));
        if (fits(above)) end.point[k] = above;
        if (fits(below)) end.point[k] = below;
    }
    return end;
}

PlanePoints points_on(const Plane& plane) {
    constexpr int tries = 256;
    const PlanePoints simplest = points_by(plane, 1);
    PlanePoints points = simplest;
    for (int i = 1; i < tries && !points.exact; ++i) points = points_by(plane, 1 + i / 64.0);
    return points.exact ? points : simplest;
}

}  // namespace etalon
