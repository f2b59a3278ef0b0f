// Sampling of directions to emissive shapes, and their pdf.
#include "core/light/area_shape.h"

#include <numbers>

#include "core/intersect/kernels.h"
#include "core/sampling/sobol.h"
#include "core/scene/profiles.h"
#include "tests/catch.h"
#include "tests/chi_square.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::uint32_t samples = 1 << 14;

template <class Shape>
double mean_of_reciprocal_density(const Shape& shape, const Vec3& from) {
    const ScrambledSobol points(7);
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        const AreaPoint p = shape.sample(from, points(i));
        if (p.pdf > 0) sum += 1 / p.pdf;
    }
    return sum / samples;
}

/// Checks that every sample's density is pdf() of its point, and that the point is on the visible
/// surface.
template <class Shape>
void check_densities(const Shape& shape, const Vec3& from) {
    const ScrambledSobol points(11);
    for (std::uint32_t i = 0; i < 500; ++i) {
        const AreaPoint p = shape.sample(from, points(i));
        REQUIRE(p.pdf > 0);
        CHECK_THAT(shape.pdf(from, p.position, p.normal), WithinRel(p.pdf, 1e-9));
        CHECK_THAT(p.normal.length(), WithinRel(1.0, 1e-12));
    }
}

}  // namespace

TEST_CASE("A triangle across an octant is sampled by its solid angle of pi / 2", "[light]") {
    const TriangleArea octant({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    CHECK_THAT(mean_of_reciprocal_density(octant, Vec3(0)), WithinRel(pi / 2, 1e-12));
    check_densities(octant, Vec3(0));
}

TEST_CASE("Directions to a triangle are as many in each part as its solid angle asks", "[light]") {
    const Vec3 a(1, 0, 0.2), b(0, 1, 0.1), c(-0.3, 0.1, 1), from(0.1, -0.2, -0.1);
    const Vec3 middle = (b + c) / 2;
    const TriangleArea whole(a, b, c), part(a, b, middle);
    const double share =
        mean_of_reciprocal_density(part, from) / mean_of_reciprocal_density(whole, from);
    const ScrambledSobol points(3);
    int in_part = 0;
    const Vec3 border = (a - from).cross(middle - from);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const Vec3 d = whole.sample(from, points(i)).position - from;
        in_part += border.dot(d) * border.dot(b - from) > 0;
    }
    CHECK_THAT(in_part / double{samples}, WithinRel(share, 5e-3));
}

TEST_CASE("A small or distant triangle is sampled by its area", "[light]") {
    const TriangleArea small({0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0});
    check_densities(small, Vec3(0.1, 0.2, 1));
    // Nearly as a distant surface: area cosine / distance^2.
    CHECK_THAT(mean_of_reciprocal_density(small, Vec3(0, 0, 10)), WithinRel(5e-7 / 100, 1e-5));
}

namespace {

/// A trapezium of area 6 in the plane z = 1; its diagonal from a to c leaves 4 and 2.
const Vec3 corner_a(-2, -1, 1), corner_b(2, -1, 1), corner_c(1, 1, 1), corner_d(-1, 1, 1);

/// Returns which share of the samples is in the first triangle, a b c.
double share_of_first(const TwoTrianglesArea& both, const Vec3& from) {
    const Vec3 border = (corner_a - from).cross(corner_c - from);
    const ScrambledSobol points(3);
    int in_first = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        const Vec3 d = both.sample(from, points(i)).position - from;
        in_first += border.dot(d) * border.dot(corner_b - from) > 0;
    }
    return in_first / double{samples};
}

}  // namespace

TEST_CASE("Two triangles of a plane are sampled like one shape", "[light]") {
    // A side of a cube from its centre: a sixth of all directions.
    const TwoTrianglesArea side({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
    CHECK_THAT(mean_of_reciprocal_density(side, Vec3(0)), WithinRel(4 * pi / 6, 1e-12));
    check_densities(side, Vec3(0));
    const TwoTrianglesArea both(corner_a, corner_b, corner_c, corner_d);
    CHECK_THAT(both.area(), WithinRel(6.0, 1e-12));
    // Solid angles by van Oosterom and Strackee: both, and the first one's share.
    const Vec3 oblique(0.5, -0.8, 0.5), far(0.3, -0.4, -20);
    CHECK_THAT(mean_of_reciprocal_density(both, oblique), WithinRel(2.9907886086, 1e-9));
    CHECK_THAT(share_of_first(both, oblique), WithinRel(0.9410714638, 5e-3));
    check_densities(both, oblique);
    // From afar by their area, of which the first has two thirds.
    CHECK_THAT(mean_of_reciprocal_density(both, far), WithinRel(0.0135443612, 1e-3));
    CHECK_THAT(share_of_first(both, far), WithinRel(2.0 / 3, 5e-3));
    check_densities(both, far);
}

TEST_CASE("Neighbouring triangles of one plane and one material are a quadrilateral", "[light]") {
    Geometry g;
    for (const Vec3& corner :
         {Vec3(0), Vec3(2, 0, 0), Vec3(3, 1, 0), Vec3(0, 1, 0), Vec3(0, 1, 0.1)}) {
        g.add_vertex(corner);
    }
    for (const Triangle& t : {Triangle{{0, 1, 2}}, Triangle{{0, 2, 3}},     // 0
                              Triangle{{1, 2, 0}}, Triangle{{3, 0, 2}},     // 2: begun elsewhere
                              Triangle{{0, 1, 2}}, Triangle{{0, 2, 4}},     // 4: bent
                              Triangle{{0, 1, 2}}, Triangle{{0, 3, 2}}}) {  // 6: turned over
        g.add(t, 0);
    }
    g.add(Triangle{{0, 1, 2}}, 0);  // 8: of another material
    g.add(Triangle{{0, 2, 3}}, 1);
    for (const std::uint32_t first : {0, 2}) {
        const auto both = quadrilateral(g, first);
        REQUIRE(both);
        CHECK_THAT(both->area(), WithinRel(2.5, 1e-12));
    }
    for (const std::uint32_t first : {4, 6, 8, 9}) CHECK_FALSE(quadrilateral(g, first));
}

TEST_CASE("A sphere is sampled by the cone in which it is seen", "[light]") {
    for (const double distance : {1.0001, 2.0, 1e3, 1e7}) {
        const SphereArea sphere(Sphere{Vec3(1, 2, 3), 1});
        const Vec3 from = Vec3(1, 2, 3) + distance * normalized(Vec3(1, -2, 0.5));
        const double sine = 1 / distance;
        const double cap = 2 * pi * sine * sine / (1 + std::sqrt(1 - sine * sine));
        CHECK_THAT(mean_of_reciprocal_density(sphere, from), WithinRel(cap, 1e-6));
        check_densities(sphere, from);
    }
}

TEST_CASE("A sphere is all around a point in it", "[light]") {
    const SphereArea sphere(Sphere{Vec3(0), 2});
    CHECK_THAT(mean_of_reciprocal_density(sphere, Vec3(0.5, 0.3, -1)), WithinRel(4 * pi, 1e-2));
    check_densities(sphere, Vec3(0.5, 0.3, -1));
}

TEST_CASE("From points of a sphere itself the whole sphere is sampled", "[light]") {
    const SphereArea sphere(Sphere{Vec3(0.1, 0.2, 0.3), 20});
    const ScrambledSobol points(13);
    for (std::uint32_t i = 0; i < 200; ++i) {
        const Vec3 from =
            sphere.sample(Vec3(0), points(i)).position;  // on either side, depending on rounding
        const AreaPoint p = sphere.sample(from, points(i + 1000));
        CHECK((p.position - from).length() > 1e-3);
        CHECK_THAT(sphere.pdf(from, p.position, p.normal), WithinRel(p.pdf, 1e-9));
    }
}

TEST_CASE("A disk and a ring are seen under the angles between their circles", "[light]") {
    const auto cap = [](double radius, double height) {
        return 2 * pi * (1 - height / std::hypot(radius, height));
    };
    const Vec3 normal = normalized(Vec3(1, 2, 2)), from = 1.5 * normal;
    const RingArea disk(Ring{Vec3(0), 5.0 * normal, 0, 1}), ring(Ring{Vec3(0), normal, 0.5, 1});
    CHECK_THAT(mean_of_reciprocal_density(disk, from), WithinRel(cap(1, 1.5), 1e-4));
    CHECK_THAT(mean_of_reciprocal_density(ring, from),
               WithinRel(cap(1, 1.5) - cap(0.5, 1.5), 1e-4));
    check_densities(ring, from);
}

TEST_CASE("An ellipsoid that is a sphere is sampled over the sphere's area", "[light]") {
    const Affine map{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 1}};
    const EllipsoidArea ball(map);
    CHECK_THAT(ball.area(), WithinRel(16 * pi, 1e-9));
    CHECK_THAT(mean_of_reciprocal_density(ball, Vec3(1.5, 1, 1)), WithinRel(4 * pi, 1e-2));
}

TEST_CASE("An ellipsoid is all around a point in it, a mirrored one, too", "[light]") {
    const Affine map{{0, 3, 0}, {1, 0.2, 0}, {0, 0.5, 0.7}, {4, 5, 6}};
    const EllipsoidArea ellipsoid(map);
    CHECK_THAT(mean_of_reciprocal_density(ellipsoid, Vec3(4.2, 5.1, 6.1)), WithinRel(4 * pi, 2e-2));
    check_densities(ellipsoid, Vec3(4.2, 5.1, 6.1));
    const ScrambledSobol points(1);
    for (std::uint32_t i = 0; i < 100; ++i) {  // outward
        const AreaPoint p = ellipsoid.sample(Vec3(0), points(i));
        CHECK(p.normal.dot(p.position - map.origin) > 0);
    }
}

namespace {

const Affine sheared{{1, 0.2, 0}, {0.5, 1, 0.3}, {-0.4, 0.1, -1.5}, {4, 5, 6}};
const Affine turned{{0, 0, 2}, {2, 0, 0}, {0, 2, 0}, {1, -2, 3}};

RevolvedArea area_of(const Affine& map, const Profile& profile, double degrees = 360) {
    return RevolvedArea(Revolved(map, profile, Sector(degrees)));
}

/// Returns the p-value of a chi-square test of directions to the surface; a direction hits it at up
/// to two points.
double chi_square(const Revolved& surface, const Vec3& from, double density_factor = 1) {
    const RevolvedArea area(surface);
    Geometry geometry;
    geometry.add(surface, 0);
    const test::SphereSampler sampler = [&](Random& random) -> std::optional<Vec3> {
        const double u = random.uniform(), v = random.uniform();
        return normalized(area.sample(from, {u, v}).position - from);
    };
    const test::SphereDensity density = [&](const Vec3& direction) {
        double sum = 0;
        Ray ray{from, direction};
        for (int k = 0; k < 2; ++k) {
            const double t = primitive_first_hit(geometry, 0, RayQuery(ray));
            if (!(t < infinity)) break;
            const SurfacePoint p = surface_at(geometry, ray, {t, 0});
            sum += area.pdf(from, p.position, p.normal);
            ray.tmin = t;
        }
        return density_factor * sum;
    };
    return test::chi_square_probability(sampler, density, 5);
}

}  // namespace

TEST_CASE("Surfaces of revolution are sampled over the whole angle they are seen under") {
    const auto angle = [](const Profile& profile, const Vec3& from) {
        return mean_of_reciprocal_density(area_of(turned, profile), turned.point(from));
    };
    const double from_centre = 4 * pi * 0.5 / std::sqrt(1.25);
    CHECK_THAT(angle(profiles::cylinder(), {0, 0, 0.5}), WithinRel(from_centre, 5e-3));
    CHECK_THAT(angle(profiles::cone(), {0, 0, -0.999}), WithinRel(2 * pi, 1e-2));
    CHECK_THAT(angle(profiles::paraboloid(0), {0, 0, 0.999}), WithinRel(2 * pi, 1e-2));
    CHECK_THAT(angle(profiles::sphere(0, 1), {0, 0, 0}), WithinRel(2 * pi, 1e-3));
    const double ends = 2 * 2 * pi * (1 - 1 / std::sqrt(2));
    CHECK_THAT(angle(profiles::hyperboloid(0.25, 0.75, -1, 1), {0, 0, 0}),
               WithinRel(4 * pi - ends, 5e-3));
    const double cap = 2 * pi * (1 - 0.5 / std::hypot(0.5, 1)),
                 hole = 2 * pi * (1 - 0.5 / std::hypot(0.5, 0.25));
    CHECK_THAT(angle(profiles::disk(0.25), {0, 0, 0.5}), WithinRel(cap - hole, 5e-3));
}

TEST_CASE("Parts of surfaces of revolution are sampled within their turn and height") {
    const double cap = 2 * pi * (1 - 0.5 / std::hypot(0.5, 1));
    CHECK_THAT(mean_of_reciprocal_density(area_of({}, profiles::disk(0), 135), {0, 0, 0.5}),
               WithinRel(cap * 135 / 360, 5e-3));
    CHECK_THAT(
        mean_of_reciprocal_density(area_of(sheared, profiles::sphere(-1, 1), 180), {4, 5, 6}),
        WithinRel(2 * pi, 1e-2));
    const Revolved part(sheared, profiles::paraboloid(0.25), Sector(100));
    const RevolvedArea area(part);
    const ScrambledSobol points(5);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const AreaPoint p = area.sample(Vec3(0), points(i));
        const Vec3 local = part.frame.vector(p.position - sheared.origin);
        const double phi = std::atan2(local.y, local.x);
        CHECK((phi >= -1e-12 && phi <= 100 * pi / 180 + 1e-12));
        CHECK((local.z >= 0.25 - 1e-12 && local.z <= 1 + 1e-12));
    }
}

TEST_CASE("A flat surface of revolution is bounded about a point of its plane") {
    for (const double degrees : {30.0, 90.0, 250.0, 360.0}) {
        const RevolvedArea area = area_of(sheared, profiles::disk(0.25), degrees);
        const auto [centre, radius] = area.bounds();
        CHECK_THAT(area.flat_normal()->dot(centre - sheared.origin), WithinAbs(0, 1e-12));
        const ScrambledSobol points(5);
        for (std::uint32_t i = 0; i < 1000; ++i) {
            const AreaPoint p = area.sample(Vec3(0), points(i));
            CHECK((p.position - centre).length() <= radius * (1 + 1e-12));
        }
    }
}

TEST_CASE("The density of a point of a surface of revolution is that of its sample") {
    for (const Profile& profile :
         {profiles::sphere(-0.5, 0.75), profiles::cylinder(), profiles::cone(),
          profiles::paraboloid(0), profiles::hyperboloid(0.25, 0.75, -1, 1), profiles::disk(0.5)}) {
        check_densities(area_of(sheared, profile, 210), Vec3(0.1, 0.2, 0.3));
    }
}

TEST_CASE("Directions to a surface of revolution are drawn with the density that is said of them") {
    const std::pair<const char*, Profile> curves[] = {
        {"sphere", profiles::sphere(-0.5, 0.75)},
        {"cylinder", profiles::cylinder()},
        {"cone", profiles::cone()},
        {"paraboloid", profiles::paraboloid(0)},
        {"hyperboloid", profiles::hyperboloid(0.25, 0.75, -1, 1)},
        {"disk", profiles::disk(0.5)}};
    const double significance = test::sidak(0.01, 2 * std::size(curves));
    for (const auto& [name, curve] : curves) {
        INFO(name);
        const Vec3 inside = sheared.point({0.1, 0.05, 0.5 * (curve.low + curve.high) + 0.05});
        CHECK(chi_square({sheared, curve, Sector(360)}, inside) > significance);
        CHECK(chi_square({sheared, curve, Sector(250)}, inside) > significance);
    }
}

TEST_CASE("The test of directions finds a density that is off by a fiftieth") {
    const Revolved dome(sheared, profiles::sphere(0, 1), Sector(360));
    CHECK(chi_square(dome, {4, 5, 6.1}, 0.98) < 1e-4);
}
