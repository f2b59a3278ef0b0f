#include "core/formats/write/facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/numerics/rounding.h"
#include "core/numerics/transforms.h"

namespace etalon {
namespace {

constexpr int around = 48, rings = 24;

/// A point of a unit shape with its normal.
struct LocalPoint {
    Vec3 position, normal;
};

/// Transforms facets of a unit shape to world space.
class Facets {
  public:
    Facets(const Affine& to_world, const FacetSink& take)
        : to_world_(to_world), take_(take), normal_map_(to_world), mirrored_(mirrors(to_world)) {}

    void smooth(std::vector<LocalPoint> points) const {
        if (mirrored_) std::reverse(points.begin(), points.end());
        std::vector<Vec3> corners, normals;
        for (const LocalPoint& p : points) {
            corners.push_back(to_world_.point(p.position));
            normals.push_back(unit_vector(normal_map_(p.normal)));
        }
        take_(corners, normals);
    }

    void flat(std::vector<Vec3> corners) const {
        if (mirrored_) std::reverse(corners.begin(), corners.end());
        for (Vec3& p : corners) p = to_world_.point(p);
        take_(corners, {});
    }

  private:
    const Affine& to_world_;
    const FacetSink& take_;
    NormalMap normal_map_;
    bool mirrored_;
};

/// Returns a point of the unit circle; the last step repeats the first point bit for bit.
Vec3 on_circle(int step) {
    const double angle = 2 * std::numbers::pi / around * (step % around);
    return {std::cos(angle), std::sin(angle), 0};
}

/// Returns a point of the unit sphere; the rings go from pole to pole.
LocalPoint on_sphere(int ring, int step) {
    const double angle = std::numbers::pi / rings * ring;
    const bool pole = ring == 0 || ring == rings;
    const Vec3 p = (pole ? 0 : std::sin(angle)) * on_circle(step) - Vec3(0, 0, std::cos(angle));
    return {p, p};
}

}  // namespace

void to_facets(const Ellipsoid& shape, const FacetSink& take) {
    const Facets out(shape.to_world, take);
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < around; ++step) {
            std::vector<LocalPoint> corners = {on_sphere(ring, step)};
            if (ring > 0) corners.push_back(on_sphere(ring, step + 1));
            corners.push_back(on_sphere(ring + 1, step + 1));
            if (ring + 1 < rings) corners.push_back(on_sphere(ring + 1, step));
            out.smooth(corners);
        }
    }
}

void to_facets(const ClosedCylinder& shape, const FacetSink& take) {
    const Facets out(shape.to_world, take);
    const Vec3 up(0, 0, 1);
    std::vector<Vec3> bottom, top;
    for (int step = 0; step < around; ++step) {
        const Vec3 a = on_circle(step), b = on_circle(step + 1);
        out.smooth({{a, a}, {b, b}, {b + up, b}, {a + up, a}});
        bottom.insert(bottom.begin(), a);
        top.push_back(a + up);
    }
    out.flat(bottom);
    out.flat(top);
}

void to_facets(const Cone& cone, const FacetSink& take) {
    const Vec3 axis = cone.top - cone.base;
    const double height = std::sqrt(axis.dot(axis));
    const Affine place = about_axis(cone.base, axis);
    const Facets out(place, take);
    const Vec3 up(0, 0, height), lean(0, 0, (cone.base_radius - cone.top_radius) / height);
    for (int step = 0; step < around; ++step) {
        const Vec3 a = on_circle(step), b = on_circle(step + 1);
        out.smooth({{cone.base_radius * a, a + lean},
                    {cone.base_radius * b, b + lean},
                    {cone.top_radius * b + up, b + lean},
                    {cone.top_radius * a + up, a + lean}});
    }
}

void to_facets(const Ring& ring, const FacetSink& take) {
    const Affine place = about_axis(ring.centre, ring.normal);
    const Facets out(place, take);
    for (int step = 0; step < around; ++step) {
        const Vec3 a = on_circle(step), b = on_circle(step + 1);
        std::vector<Vec3> corners = {ring.inner * a, ring.outer * a, ring.outer * b};
        if (ring.inner > 0) corners.push_back(ring.inner * b);
        if (ring.inner < ring.outer) out.flat(corners);
    }
}

}  // namespace etalon
