// Curves: tests beyond the table of shapes.
#include <numbers>

#include "core/intersect/kernels.h"
#include "core/intersect/parametrization.h"
#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;

namespace {

Geometry one(const BezierCurve& curve, const Affine& map = {}) {
    Geometry g;
    g.add(Curve(curve, map), 0);
    return g;
}

/// A straight curve along x from -1 to 1, with equidistant control points and a width of 1/5.
BezierCurve line(CurveType type) {
    BezierCurve c{};
    for (std::size_t i = 0; i < 4; ++i)
        c.points[i] = Vec3f(2 * static_cast<float>(i) / 3 - 1, 0, 0);
    c.widths = {0.2F, 0.2F};
    c.type = type;
    return c;
}

BezierCurve bent(CurveType type) {
    BezierCurve c{{Vec3f(-1, -0.5F, 0), Vec3f(-0.25F, 1.5F, 0.5F), Vec3f(0.25F, -1.5F, -0.25F),
                   Vec3f(1, 0.5F, 0.25F)},
                  {0.1F, 0.05F}};
    c.normals = {Vec3f(0, 0, 1), Vec3f(0, 1, 0)};
    c.type = type;
    return c;
}

constexpr std::array types = {CurveType::flat, CurveType::ribbon, CurveType::cylinder};

double t_of(const Geometry& g, const Ray& ray) {
    return primitive_first_hit(g, 0, RayQuery(ray));
}

Ray down(double x, double y) {
    return {{x, y, 5}, {0, 0, -2}};
}

}  // namespace

TEST_CASE("Curve: given a straight one, then it is hit within half its width") {
    for (const CurveType type : types) {
        const Geometry g = one(line(type));
        CHECK_THAT(t_of(g, down(0.3, 0.099)), WithinAbs(2.5, 1e-15));
        CHECK_THAT(t_of(g, down(0.3, -0.099)), WithinAbs(2.5, 1e-15));
        CHECK(std::isnan(t_of(g, down(0.3, 0.101))));
        CHECK(std::isnan(t_of(g, down(1.001, 0))));
        CHECK_THAT(t_of(g, down(0.999, 0)), WithinAbs(2.5, 1e-15));
    }
}

TEST_CASE("Curve: given a hit, then u is along it and v across, with pbrt-v3's normals") {
    for (const CurveType type : {CurveType::flat, CurveType::cylinder}) {
        const Geometry g = one(line(type));
        const Ray ray = down(0.5, 0.04);
        const SurfacePoint p = surface_at(g, ray, {t_of(g, ray), 0});
        const Parametrization at = parametrization_at(g, p);
        CHECK((p.position - Vec3(0.5, 0.04, 0)).length() < 1e-8);
        CHECK_THAT(at.uv.x, WithinAbs(0.75, 1e-7));
        CHECK_THAT(at.uv.y, WithinAbs(0.3, 1e-7));
        const double angle = type == CurveType::flat ? 0 : (0.3 - 0.5) * std::numbers::pi;
        CHECK((p.normal - Vec3(0, -std::sin(angle), -std::cos(angle))).length() < 1e-6);
        CHECK((at.dpdu - Vec3(2, 0, 0)).length() < 1e-6);
        CHECK_THAT(at.dpdv.length(), WithinAbs(0.2, 1e-7));
        CHECK(at.dpdu.cross(at.dpdv).dot(p.normal) > 0);
    }
}

TEST_CASE("Curve: given a ribbon, then it is as broad as its normal lets it be seen") {
    const Geometry g = one(line(CurveType::ribbon));
    const Vec3 d(0, std::sqrt(0.75), -0.5);  // at 60 degrees from the normal
    const Vec3 across(0, 0.5, std::sqrt(0.75));
    CHECK(t_of(g, {0.049 * across - 3.0 * d, d}) < 4);
    CHECK(std::isnan(t_of(g, {0.051 * across - 3.0 * d, d})));
    const Ray ray{0.02 * across - 3.0 * d, d};
    const SurfacePoint p = surface_at(g, ray, {t_of(g, ray), 0});
    CHECK((p.normal - Vec3(0, 0, 1)).length() < 1e-7);
    CHECK_THAT(std::abs(parametrization_at(g, p).uv.y - 0.5), WithinAbs(0.2, 1e-6));
}

TEST_CASE("Curve: given two parallel rays, then the derivatives lead from hit to hit") {
    const Affine map{{1, 0.25, 0}, {0, -0.5, 0.25}, {0.25, 0, 1}, {3, 0, 0.5}};
    BezierCurve exact = line(CurveType::flat);  // whose points are exactly equidistant
    for (std::size_t i = 0; i < 4; ++i) exact.points[i].x = static_cast<float>(i) - 1.5F;
    const Geometry g = one(exact, map);
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const Vec3 d = random.direction(), aim = map.point({random.uniform(-0.9, 0.9), 0, 0});
        const Ray a{aim - 4.0 * d, d}, b{a.origin + 1e-6 * random.in_cube(), d};
        const SurfacePoint p = surface_at(g, a, {t_of(g, a), 0}),
                           q = surface_at(g, b, {t_of(g, b), 0});
        const Parametrization at = parametrization_at(g, p), to = parametrization_at(g, q);
        const Vec3 expected = (to.uv.x - at.uv.x) * at.dpdu + (to.uv.y - at.uv.y) * at.dpdv;
        CAPTURE(i, at.uv, to.uv);
        REQUIRE((q.position - p.position - expected).length() < 1e-9);
    }
}

TEST_CASE("Curve: given a ray that leaves it, then it does not hit it within a width") {
    for (const CurveType type : types) {
        const Geometry g = one(bent(type));
        Random random(2);
        int left = 0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 from = 3.0 * random.direction();
            const Ray ray{from, random.in_cube(0.5) - from};
            const double t = t_of(g, ray);
            if (std::isnan(t)) continue;
            ++left;
            const SurfacePoint p = surface_at(g, ray, {t, 0});
            const Ray away = spawn_ray(p, random.direction());
            CAPTURE(i);
            REQUIRE_FALSE(t_of(g, away) < 0.05);
        }
        CHECK(left > 100);
    }
}

TEST_CASE("Curve: given its segments, then together they are hit where the whole is") {
    const Geometry whole = one(bent(CurveType::cylinder));
    Geometry parts;
    for (std::uint32_t i = 0; i < 8; ++i) {
        parts.add(Curve(bent(CurveType::cylinder), Affine{}, {i, 8}), 0);
    }
    CHECK(memory_bytes(parts) < memory_bytes(whole) + 8 * 64);
    Random random(3);
    int same = 0, hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 from = 3.0 * random.direction();
        const Ray ray{from, random.in_cube(0.7) - from};
        const double t = t_of(whole, ray);
        double nearest = infinity;
        for (std::uint32_t k = 0; k < 8; ++k) {
            const double part = primitive_first_hit(parts, k, RayQuery(ray));
            if (part < nearest) nearest = part;
        }
        if (std::isnan(t)) continue;
        ++hits;
        same += std::abs(nearest - t) < 0.01 ? 1 : 0;
    }
    CHECK(hits > 100);
    CHECK(same >= hits * 97 / 100);  // at the edges only one of them may be hit
}

TEST_CASE("A curve under a map whose inverse is but roundings does not exist") {
    const Affine next_to_flat{
        {2.0000000000000004, 0.99999999999999989, 0}, {0, 0, -3}, {2, 1, 0}, {0, 0, 0}};
    CHECK_FALSE(CurveTransform(next_to_flat).exists());
    const Affine sheared{{1, 0, 0}, {1e6, 1, 0}, {0, 0, 1e-9}, {0, 0, 0}};
    CHECK(CurveTransform(sheared).exists());
}

namespace {

/// Returns a map whose longest axis is about `stretch` times the other two, which flattens a curve.
Affine flattened(double stretch) {
    return {{1, 0.25, 0}, {0, 1 / stretch, 0}, {0, 0, 1 / stretch}, {3, 0, 0.5}};
}

bool is_inside(const Box3& box, const Vec3& p, double slack) {
    const Vec3 s(slack);
    return Box3(box.min - s, box.max + s).intersects(p);
}

}  // namespace

TEST_CASE("Curve: given a map that flattens it, then rays from far away hit it in its bounds") {
    Random random(3);
    for (const double stretch : {4.0, 0x1p10, 0x1p20, 0x1p40}) {
        const Affine map = flattened(stretch);
        const Geometry g = one(bent(CurveType::flat), map);
        const Box3 box = primitive_bounds(g, 0);
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const double distance = std::ldexp(1, static_cast<int>(random.index(24)));
            const Vec3 d = random.direction(), aim = map.point({random.uniform(-1, 1), 0, 0});
            const Ray ray{aim - distance * d, d};
            const double t = t_of(g, ray);
            if (std::isnan(t)) continue;
            ++hits;
            CAPTURE(stretch, distance, t, box.min, box.max);
            REQUIRE(is_inside(box, ray.origin + t * d, 0x1p-50 * distance));
        }
        CHECK(hits > 0);
    }
}

TEST_CASE("Curve: given rays in object space from 2^57 away, then it is hit where they pass it") {
    // A nearly flat instance transforms ordinary rays to such rays. Each goes through (x, y, 0).
    const auto past = [](double x, double y) {
        return Ray{{x + 30, y - 14, 0x1p57}, {-30, 14, -0x1p57}};
    };
    for (const CurveType type : {CurveType::flat, CurveType::cylinder}) {
        const Geometry g = one(line(type), {{1, 4, 0}, {0, -4, 0}, {0, 3, 3}, Vec3(0)});
        for (int i = -64; i <= 64; ++i) {
            CHECK(std::isnan(t_of(g, past(0.25 * i, 8))));
            CHECK(std::isnan(t_of(g, past(4, 0.25 * i))));
        }
        for (int i = -7; i <= 7; ++i) CHECK(t_of(g, past(0.125 * i, 0.5 * i)) == 1);
    }
}

TEST_CASE("Curve: given a map that flattens it to less than roundings, then it is nowhere") {
    for (const double stretch : {0x1p51, 1e20, 1e300}) {
        const Geometry g = one(bent(CurveType::flat), flattened(stretch));
        CHECK(primitive_bounds(g, 0).isEmpty());
        CHECK(std::isnan(t_of(g, {{3, 0, 5}, {0, 0, -1}})));
        CHECK(std::isnan(t_of(g, {{3, 0, 0.5}, {1, 0, 0}})));
    }
}
