// Compares (u, v), dpdu and dpdv of every shape with differences between nearby hits.
#include <numbers>
#include <optional>

#include "core/intersect/kernels.h"
#include "core/intersect/parametrization.h"
#include "core/scene/profiles.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

constexpr double pi = std::numbers::pi;

struct Sample {
    SurfacePoint point;
    Parametrization at;
};

std::optional<Sample> sample(const Geometry& geometry, const Ray& ray) {
    const double t = primitive_first_hit(geometry, 0, RayQuery(ray));
    if (!(t <= infinity)) return std::nullopt;
    const SurfacePoint point = surface_at(geometry, ray, {t, 0});
    return Sample{point, parametrization_at(geometry, point)};
}

Sample known(const Geometry& geometry, const Vec3& origin, const Vec3& target) {
    return sample(geometry, {origin, target - origin}).value();
}

template <class Shape>
Geometry one(const Shape& shape) {
    Geometry geometry;
    geometry.add(shape, 0);
    return geometry;
}

bool is_close(const Vec2& a, const Vec2& b) {
    return (a - b).length() < 1e-14;
}

bool is_in_unit_square(const Vec2& uv) {
    return 0 <= uv.x && uv.x <= 1 && 0 <= uv.y && uv.y <= 1;
}

bool is_tangent(const Vec3& v, const Vec3& normal) {
    return is_finite(v) && v != Vec3(0) && std::abs(v.dot(normal)) <= 1e-6 * v.length();
}

/// Returns a point of the surface a small random step away from `s`.
std::optional<Sample> neighbour(const ShapeCase& shape, const Sample& s, Random& random) {
    const Vec3& n = s.point.normal;
    const double step = shape.size * std::pow(10.0, random.uniform(-8, -5));
    Vec3 u, v;
    orthonormal_basis(n, u, v);
    const double angle = random.uniform(0, 2 * pi);
    const Vec3 target = s.point.position + step * (std::cos(angle) * u + std::sin(angle) * v);
    const double away = 10 * step + 10 * s.point.error.length();
    const auto found = sample(shape.scene.geometry, {target + away * n, -n});
    if (!found || (found->point.position - target).length() > step) return std::nullopt;
    return found;
}

/// Difference between a step on the surface and its linear estimate by the derivatives, its length,
/// and the tolerance for roundings and the change of the derivatives.
struct Step {
    double off, length, tolerance;

    /// Returns whether a wrong derivative would be detected.
    bool is_decisive() const { return tolerance < 0.1 * length; }
};

/// Returns false across an edge of a box, or next to a pole.
bool derivatives_are_close(const Parametrization& a, const Parametrization& b) {
    return (a.dpdu - b.dpdu).length() < 0.02 * a.dpdu.length() &&
           (a.dpdv - b.dpdv).length() < 0.02 * a.dpdv.length();
}

/// Returns whether a coordinate is at the end of its range, where roundings are clamped.
bool is_at_end(const Vec2& uv) {
    const auto ends = [](double x) { return x == 0 || x == 1; };
    return ends(uv.x) || ends(uv.y);
}

/// Returns false if the derivatives are nearly parallel, as on a sliver: there (u, v) magnifies
/// roundings too much for a comparison.
bool is_well_conditioned(const Parametrization& p) {
    return p.dpdu.cross(p.dpdv).length() > 0.1 * p.dpdu.length() * p.dpdv.length();
}

Step step(const Sample& a, const Sample& b) {
    const Vec3 moved = b.point.position - a.point.position;
    Vec2 d = b.at.uv - a.at.uv;
    d -= Vec2(std::round(d.x), std::round(d.y));  // over the seam of an angle
    const Vec3 expected = d.x * a.at.dpdu + d.y * a.at.dpdv;
    const double change = std::abs(d.x) * (b.at.dpdu - a.at.dpdu).length() +
                          std::abs(d.y) * (b.at.dpdv - a.at.dpdv).length();
    // With a map of condition number 1e6, (u, v) is accurate to 1e-9.
    const double rounding = a.point.error.length() + b.point.error.length() +
                            1e-9 * (a.at.dpdu.length() + a.at.dpdv.length());
    const double length = moved.length();
    return {(moved - expected).length(), length, 1e-3 * length + 2 * change + rounding};
}

/// Returns whether the point is so near an apex that the normal is lost in roundings.
bool is_at_tip(const ShapeCase& shape, const SurfacePoint& p) {
    return std::any_of(shape.tips.begin(), shape.tips.end(), [&](const Vec3& tip) {
        return (p.position - tip).length() < 1e-9 * shape.size;
    });
}

/// Returns whether a shape is so flat that its (u, v) is well conditioned nowhere.
bool is_flattened(const ShapeCase& shape) {
    return shape.name == "triangle, sliver" || shape.name.ends_with("condition 1e8");
}

bool has_unit_square(const ShapeCase& shape) {
    const ShapeKind kind = shape.scene.geometry.primitives[0].kind;
    return kind != kind_of<Plane>() && kind != kind_of<Polygon>();
}

double along_normal(const Sample& s) {
    return s.at.dpdu.cross(s.at.dpdv).dot(s.point.normal);
}

}  // namespace

TEST_CASE("parametrization_at: given any hit, then (u, v) and its derivatives are on the surface") {
    for (const ShapeCase& shape : shape_cases()) {
        Random random(5);
        int hits = 0;
        for (int i = 0; i < 1000; ++i) {
            const AimedRay aimed = aimed_ray(shape, i, random);
            const auto s = sample(shape.scene.geometry, aimed.ray);
            if (!s || is_at_tip(shape, s->point)) continue;
            ++hits;
            const auto& [uv, dpdu, dpdv] = s->at;
            CAPTURE(shape.name, *aimed.target, aimed.ray_generator, i, uv, dpdu, dpdv,
                    s->point.normal);
            REQUIRE((std::isfinite(uv.x) && std::isfinite(uv.y)));
            if (has_unit_square(shape)) REQUIRE(is_in_unit_square(uv));
            REQUIRE(is_tangent(dpdu, s->point.normal));
            REQUIRE(is_tangent(dpdv, s->point.normal));
        }
        CAPTURE(shape.name);
        REQUIRE(hits > 100);
    }
}

TEST_CASE("parametrization_at: given two hits close together, then the derivatives lead over") {
    for (const ShapeCase& shape : shape_cases()) {
        // A curve faces each ray, so that two rays have different derivatives: see curve_test.
        if (shape.scene.geometry.primitives[0].kind == kind_of<Curve>()) continue;
        Random random(6);
        int considered = 0, decisive = 0;
        for (int i = 0; i < 2000; ++i) {
            const auto a = sample(shape.scene.geometry, aimed_ray(shape, i, random).ray);
            const auto b = a ? neighbour(shape, *a, random) : std::nullopt;
            if (!b || !derivatives_are_close(a->at, b->at)) continue;
            if (!is_well_conditioned(a->at) || is_at_end(a->at.uv) || is_at_end(b->at.uv)) continue;
            ++considered;
            const Step s = step(*a, *b);
            CAPTURE(shape.name, i, a->at.uv, b->at.uv, a->at.dpdu, a->at.dpdv, s.length);
            REQUIRE(s.off <= s.tolerance);
            decisive += s.is_decisive() ? 1 : 0;
        }
        CAPTURE(shape.name);
        if (is_flattened(shape)) {
            CHECK(considered == 0);
        } else {
            CHECK(decisive > 10);
        }
    }
}

TEST_CASE("parametrization_at: given a sphere, then u turns about z and v grows from the south") {
    const Geometry g = one(Sphere{{1, 2, 3}, 2});
    const auto towards = [&](const Vec3& d) {
        return known(g, Vec3(1, 2, 3) + 5.0 * d, {1, 2, 3});
    };
    CHECK(is_close(towards({1, 0, 0}).at.uv, {0, 0.5}));
    CHECK(is_close(towards({0, 1, 0}).at.uv, {0.25, 0.5}));
    CHECK(is_close(towards({0, -1, 0}).at.uv, {0.75, 0.5}));
    CHECK(towards({0, 0, -1}).at.uv.y == 0);
    CHECK(towards({0, 0, 1}).at.uv.y == 1);
    const Parametrization at = towards({1, 0, 0}).at;
    CHECK((at.dpdu - Vec3(0, 4 * pi, 0)).length() < 1e-14);
    CHECK((at.dpdv - Vec3(0, 0, 2 * pi)).length() < 1e-14);
}

TEST_CASE("parametrization_at: given a cylinder and a ring, then v is along the axis and inward") {
    const Sample side = known(one(Cone{{0, 0, 1}, {0, 0, 5}, 2, 2}), {9, 0, 2}, {0, 0, 2});
    CHECK(side.at.uv.y == 0.25);
    CHECK(side.at.dpdv == Vec3(0, 0, 4));
    const Sample ring = known(one(Ring{{0, 0, 0}, {0, 0, 7}, 1, 3}), {0, 1.5, 9}, {0, 1.5, 0});
    CHECK(is_close(ring.at.uv, {0.25, 0.75}));
    CHECK((ring.at.dpdv - Vec3(0, -2, 0)).length() < 1e-14);
}

TEST_CASE("parametrization_at: given a triangle, then its corners are (0, 0), (1, 0) and (1, 1)") {
    Geometry g;
    g.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    g.add(Triangle{{0, 1, 2}}, 0);
    CHECK(known(g, {0, 0, 1}, {0, 0, 0}).at.uv == Vec2(0, 0));
    CHECK(known(g, {4, 0, 1}, {4, 0, 0}).at.uv == Vec2(1, 0));
    CHECK(known(g, {0, 4, 1}, {0, 4, 0}).at.uv == Vec2(1, 1));
    CHECK(known(g, {1, 2, 1}, {1, 2, 0}).at.uv == Vec2(0.75, 0.5));
}

TEST_CASE("parametrization_at: given the face of a box, then it is whole and not mirrored") {
    const Geometry g = one(Box{{0, 0, 0}, {2, 4, 8}});
    const Sample max = known(g, {9, 1, 2}, {0, 1, 2}), min = known(g, {-9, 1, 2}, {0, 1, 2});
    CHECK(max.at.uv == Vec2(0.25, 0.25));
    CHECK(min.at.uv == Vec2(0.75, 0.25));
    CHECK(max.at.dpdu == Vec3(0, 4, 0));
    CHECK(min.at.dpdu == Vec3(0, -4, 0));
    CHECK(min.at.dpdv == Vec3(0, 0, 8));
}

TEST_CASE(
    "parametrization_at: given any shape, then dpdu x dpdv turns with a mirroring map alone") {
    for (const ShapeCase& shape : shape_cases()) {
        const Geometry& geometry = shape.scene.geometry;
        const ShapeKind kind = geometry.primitives[0].kind;
        const bool is_image = kind == kind_of<Ellipsoid>() || kind == kind_of<ClosedCylinder>() ||
                              kind == kind_of<Revolved>();
        if (is_image) continue;
        Random random(7);
        for (int i = 0; i < 200; ++i) {
            const auto s = sample(geometry, aimed_ray(shape, i, random).ray);
            CAPTURE(shape.name, i);
            if (s) REQUIRE(along_normal(*s) > 0);
        }
    }
    const double mirror = GENERATE(1.0, -1.0);
    const Affine map{{mirror * 2, 0, 0}, {0, 3, 0}, {1, 0, 4}};
    for (const Vec3& from : {Vec3(9, 1, 2), Vec3(-9, 0, 2), Vec3(1, 9, 2), Vec3(1, 0.5, 9)}) {
        CHECK(mirror * along_normal(known(one(Ellipsoid(map)), from, {0.5, 0, 2})) > 0);
        CHECK(mirror * along_normal(known(one(ClosedCylinder(map)), from, {0.5, 0, 2})) > 0);
        const Revolved ball(map, profiles::sphere(-1, 1), Sector(360));
        CHECK(mirror * along_normal(known(one(ball), from, {0.5, 0, 2})) > 0);
    }
    const Sample below = known(one(ClosedCylinder(map)), {0.5, 0.5, -9}, {0.5, 0.5, 0});
    CHECK(mirror * along_normal(below) < 0);
}

TEST_CASE(
    "parametrization_at: given a pole, a tip or a centre, then derivatives span the tangents") {
    const Vec3 up(0, 0, 9);
    const Sample samples[] = {
        known(one(Sphere{{0, 0, 0}, 1}), up, {0, 0, 0}),
        known(one(Ellipsoid({{1, 0, 0}, {0, 2, 0}, {0, 0, -3}})), up, {0, 0, 0}),
        known(one(Cone{{0, 0, 0}, {0, 0, 2}, 1, 0}), {9, 0, 2}, {0, 0, 2}),
        known(one(Ring{{0, 0, 0}, {0, 0, 1}, 0, 1}), up, {0, 0, 0}),
        known(one(Ring{{0, 0, 0}, {0, 0, 1}, 1, 1}), {1, 0, 9}, {1, 0, 0}),
        known(one(ClosedCylinder(Affine())), up, {0, 0, 0}),
    };
    for (const Sample& s : samples) {
        CAPTURE(s.point.position, s.at.uv, s.at.dpdu, s.at.dpdv);
        CHECK(is_in_unit_square(s.at.uv));
        CHECK(is_tangent(s.at.dpdu, s.point.normal));
        CHECK(is_tangent(s.at.dpdv, s.point.normal));
        CHECK(along_normal(s) > 0.5);
    }
}
