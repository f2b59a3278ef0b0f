#include "core/light/equiangular.h"

#include "core/light/lit_range.h"
#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;

TEST_CASE("Points of a ray have the density that is said of them", "[light]") {
    const Vec3 along(0, 0, 1);
    for (const Vec3& light : {Vec3(1, 0, 3), Vec3(0.01, 0, 1), Vec3(5, 1, -4), Vec3(0, 2, 20)}) {
        for (const double end : {6.0, infinity}) {
            const Equiangular range(light, Vec3(0), along, 0.5, end);
            double integral = 0;  // up to the point of u, which must be u
            double at = 0.5;
            for (const double u : {0.1, 0.25, 0.5, 0.75, 0.9}) {
                const double to = range.sample(u);
                constexpr int steps = 20000;
                const double step = (to - at) / steps;
                for (int i = 0; i < steps; ++i)
                    integral += step * range.density(at + (i + 0.5) * step);
                at = to;
                INFO("light " << light << ", u " << u);
                CHECK_THAT(integral, WithinAbs(u, 1e-3));
            }
            CHECK(range.density(0.4) == 0);
            CHECK(range.sample(0) == Approx(0.5));
        }
        CHECK(Equiangular(light, Vec3(0), along, 0.5, 6).density(6.1) == 0);
    }
}

TEST_CASE("A ray through a light has points too", "[light]") {
    const Equiangular range({0, 0, 3}, Vec3(0), {0, 0, 1}, 0, 6);
    for (const double u : {0.0, 0.3, 0.5, 0.7, 0.999}) {
        const double at = range.sample(u);
        CHECK((at >= 0 && at <= 6));
        CHECK(std::isfinite(range.density(at)));
    }
}

TEST_CASE("The part of a ray in a spot's cone is all that the spot shines on", "[light]") {
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const SpotSource spot{random.in_cube(), random.direction(), Color(1),
                              random.uniform(-0.3, 0.999), 1};
        const Vec3 origin = random.in_cube(3), direction = random.direction();
        const double length = random.one_in(3) ? infinity : random.uniform(0, 6);
        const auto range = lit_range(spot, origin, direction, length);
        for (int k = 0; k < 50; ++k) {
            const double at = random.uniform(0, std::min(length, 10.0));
            const Vec3 way = normalized(origin + at * direction - spot.position);
            const double inside = way.dot(spot.axis) - spot.cos_total;
            const bool is_known = range && range->density(at) > 0;
            if (inside > 1e-9) CHECK(is_known);
            if (inside < -1e-9 && spot.cos_total > 0) CHECK_FALSE(is_known);
        }
    }
}

TEST_CASE("Lights with extent or without a place shine on no part of a ray", "[light]") {
    CHECK_FALSE(lit_range(DistantSource{{0, 0, 1}, Color(1)}, Vec3(0), {0, 0, 1}, 1));
    CHECK_FALSE(lit_range(AreaSource{0, 1, Color(1), false}, Vec3(0), {0, 0, 1}, 1));
    CHECK(lit_range(PointSource{Vec3(1), Color(1)}, Vec3(0), {0, 0, 1}, 1));
}
