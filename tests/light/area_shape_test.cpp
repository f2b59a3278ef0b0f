// Directions to shapes that shine, and their densities.
#include "core/light/area_shape.h"

#include <numbers>

#include "core/sampling/sobol.h"
#include "tests/catch.h"

using namespace etalon;
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

/// Every sample's density is what pdf() says of its point, and the point is seen where it is.
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
    // As good as seen face on from the distance: area cosine / distance^2.
    CHECK_THAT(mean_of_reciprocal_density(small, Vec3(0, 0, 10)), WithinRel(5e-7 / 100, 1e-5));
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
            sphere.sample(Vec3(0), points(i)).position;  // on either side by roundings
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
