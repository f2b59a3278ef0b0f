#include "core/test_rays/quadric_points.h"
#include "tests/intersect/shapes/families.h"

namespace etalon {
namespace {

ShapeCase quadric(const std::string& name, const Quadric& s) {
    ShapeCase c{name, {}, s.clip.center(), s.clip.size().length() / 2, true, {}, {}};
    c.scene.geometry.add(s, 0);
    const QuadricPoints points(s);
    c.targets.push_back(
        {"inside", [=](Random& random, const Vec3&) { return points.in_clip(random); }});
    c.targets.push_back(
        {"surface", [=](Random& random, const Vec3&) { return points.on_surface(random); }});
    c.targets.push_back(
        {"rim", [=](Random& random, const Vec3&) { return points.on_rim(random); }});
    c.targets.push_back({"silhouette", [=](Random& random, const Vec3& from) {
                             return points.silhouette(from, nearly_one(random) - 1, random);
                         }});
    return c;
}

using Coefficients = std::array<double, 10>;

/// a x^2 + e y^2 + h z^2 + 2i z + j
constexpr Coefficients upright(double a, double e, double h, double i, double j) {
    return {a, 0, 0, 0, e, 0, 0, h, i, j};
}

constexpr Coefficients sphere_form = upright(1, 1, 1, 0, -1);

/// |p - at|^2 = 1 in coordinates about another point than `at`.
constexpr Coefficients sphere_seen_from_afar(double x, double y, double z) {
    return {1, 0, 0, -x, 1, 0, -y, 1, -z, x * x + y * y + z * z - 1};
}

/// An ellipsoid along the axes of the generic frame.
ShapeCase ellipsoid(const std::string& name, const Vec3& centre, const Vec3& radii) {
    const std::array<Vec3, 3> axes = {tilted(1, 0, 0), tilted(0, 1, 0), tilted(0, 0, 1)};
    Coefficients c{};
    c[9] = -1;
    Vec3 reach2(0);
    for (int k = 0; k < 3; ++k) {
        const Vec3 v = axes[static_cast<std::size_t>(k)] / radii[k];
        const Vec3 step = radii[k] * axes[static_cast<std::size_t>(k)];
        std::size_t next = 0;
        for (int i = 0; i < 3; ++i, ++next) {
            for (int j = i; j < 3; ++j) c[next++] += v[i] * v[j];
        }
        reach2 += step * step;
    }
    const Vec3 reach(std::sqrt(reach2.x), std::sqrt(reach2.y), std::sqrt(reach2.z));
    return quadric(name, {centre, c, {centre - reach, centre + reach}});
}

}  // namespace

std::vector<ShapeCase> quadric_cases() {
    const Vec3 zero(0);
    ShapeCase cone =
        quadric("quadric, double cone", {base, upright(1, 1, -1, 0, 0), around(base, 1)});
    cone.tips.push_back(base);
    return {
        quadric("quadric, sphere", {base, sphere_form, around(base, 1)}),
        quadric("quadric, sphere far from the origin",
                {far_away, sphere_form, around(far_away, 1)}),
        quadric("quadric, sphere given from afar",
                {zero, sphere_seen_from_afar(100, -200, 50), around({100, -200, 50}, 1)}),
        quadric("quadric, part of a sphere",
                {zero, sphere_form, {{-1, -0.5, -0.25}, {0.5, 1, 0.75}}}),
        quadric("quadric, hollow sphere", {base, upright(-1, -1, -1, 0, 1), around(base, 1)}),
        ellipsoid("quadric, ellipsoid", base, {1, 2, 0.5}),
        quadric("quadric, thin ellipsoid",
                {zero, upright(1, 0.25, 0x1p20, 0, -1), {{-1, -2, -0x1p-10}, {1, 2, 0x1p-10}}}),
        ellipsoid("quadric, ellipsoid far from the origin", far_away, {2, 1, 0.5}),
        quadric("quadric, cylinder", {base, upright(1, 1, 0, 0, -1), around(base, 1)}),
        quadric("quadric, paraboloid", {zero, upright(1, 1, 0, -0.5, 0), {{-1, -1, 0}, {1, 1, 1}}}),
        quadric("quadric, saddle", {base, upright(1, -1, 0, -0.5, 0), around(base, 1)}),
        quadric("quadric, hyperboloid", {base, upright(1, 1, -1, 0, -0.25), around(base, 1)}),
        quadric("quadric, hyperboloid of two sheets",
                {base, upright(-1, -1, 2, 0, -0.25), around(base, 1)}),
        cone,
        quadric("quadric, plane", {base, {0, 0, 0, 1, 0, 0, 2, 0, 3, 0}, around(base, 1)}),
        quadric("quadric, planes that would cross",
                {base, {0, 1, 0, 0, 0, 0, 0, 0, 0, -0.01}, around(base, 1)}),
        quadric("quadric, any",
                {base, {0.3, -0.7, 0.2, 0.1, 0.5, 0.4, -0.2, -0.6, 0.3, -0.2}, around(base, 1)}),
    };
}

}  // namespace etalon
