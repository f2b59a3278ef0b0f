#include "core/medium/grid_medium.h"

#include "core/medium/homogeneous.h"
#include "tests/catch.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;

namespace {

constexpr int estimates = 100000;

/// A medium of random densities, of which many are 0, in the cube [0, 2]^3.
PhysicalMedium cloud(const Color& absorption, const Color& scattering) {
    PhysicalMedium medium{absorption, scattering};
    medium.grid = DensityGrid{{13, 6, 9}, {}, {{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}, Vec3(0)}};
    Random random(3);
    for (int i = 0; i < 13 * 6 * 9; ++i) {
        const double density = random.one_in(3) ? 0 : random.uniform(0, 3);
        medium.grid->densities.push_back(static_cast<float>(density));
    }
    return medium;
}

PhysicalMedium block(float density) {
    PhysicalMedium medium{Color(0.2F, 0.3F, 0.1F), Color(0.8F, 0.5F, 1.2F)};
    medium.grid = DensityGrid{{16, 16, 16}, std::vector<float>(4096, density), {}};
    return medium;
}

/// Rays through the cube [0, 2]^3, past it, inside it, along its axes, and leaving it.
std::vector<RaySegment> segments() {
    const auto between = [](const Vec3& a, const Vec3& b) {
        return RaySegment{a, normalized(b - a), (b - a).length()};
    };
    return {between({-1, 0.3, 0.4}, {3, 1.7, 1.2}),
            between({1, 1, -2}, {1, 1, 5}),
            between({0.2, 0.3, 0.4}, {1.5, 1.6, 0.5}),
            between({3, 3, 3}, {4, 5, 6}),
            between({1.9, 0.1, 1.5}, {-0.5, 0.1, 1.5}),
            {{1, 1, 1}, normalized(Vec3(-1, 2, 0.3)), infinity}};
}

/// Integral of the density along a segment, by many small steps.
double optical_length(const GridMedium& medium, const DensityGrid& grid, const RaySegment& s) {
    constexpr int steps = 20000;
    const double step = std::min(s.length, 6.0) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const Vec3 p = grid.to_box.point(s.point((i + 0.5) * step));
        const bool is_inside = p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= 1 && p.y <= 1 && p.z <= 1;
        if (is_inside) sum += medium.density(p) * step;
    }
    return sum;
}

}  // namespace

TEST_CASE("Densities are interpolated between the middles of cells", "[medium]") {
    PhysicalMedium medium{Color(1), Color(1)};
    medium.grid = DensityGrid{{2, 1, 1}, {1, 3}, {}};
    const GridMedium grid(medium);
    CHECK(grid.density({0.25, 0.5, 0.5}) == 1);
    CHECK(grid.density({0.5, 0.5, 0.5}) == 2);
    CHECK(grid.density({0.75, 0.5, 0.5}) == 3);
    CHECK(grid.density({1, 0.5, 0.5}) == 1.5F);  // half-way to the next cell, which is empty
    CHECK(grid.density({0.75, 0, 0.5}) == 1.5F);
    CHECK(grid.density({0.75, 0.25, 0.25}) == 3 * 0.75F * 0.75F);
}

TEST_CASE("No density is beyond the bounds that a ray is told", "[medium]") {
    const PhysicalMedium medium = cloud(Color(1), Color(1));
    const GridMedium grid(medium);
    const DensityBounds bounds(*medium.grid);
    for (const RaySegment& s : segments()) {
        const Affine& to_box = medium.grid->to_box;
        const RaySegment in_box{to_box.point(s.origin), to_box.vector(s.direction), s.length};
        DensityBounds::Traversal traversal(bounds, in_box);
        double at = traversal.begin();
        while (const auto step = traversal.next()) {
            for (int i = 0; i < 50; ++i) {
                const float density =
                    grid.density(in_box.point(at + (step->end - at) * (i + 0.5) / 50));
                CHECK(density >= step->least - 1e-6F);
                CHECK(density <= step->most + 1e-6F);
            }
            at = step->end;
        }
    }
}

TEST_CASE("The transmittance of a grid is estimated without bias", "[medium]") {
    const PhysicalMedium medium = cloud(Color(0.5F, 0, 0.1F), Color(0.5F, 0.3F, 0.4F));
    const GridMedium grid(medium);
    for (const RaySegment& s : segments()) {
        const double expected = optical_length(grid, *medium.grid, s);
        Vec3 mean(0);
        RandomSequence numbers(1, 2);
        for (int i = 0; i < estimates; ++i) {
            mean += Vec3(grid.transmittance(s, numbers)) / estimates;
        }
        for (int c = 0; c < 3; ++c) {
            CHECK_THAT(mean[c], WithinAbs(std::exp(-expected * medium.extinction()[c]), 5e-3));
        }
    }
}

TEST_CASE("Flights through a grid carry what it lets pass and scatters", "[medium]") {
    const PhysicalMedium medium = cloud(Color(0.5F, 0, 0.1F), Color(0.5F, 0.3F, 0.4F));
    const GridMedium grid(medium);
    for (const RaySegment& s : segments()) {
        const double length = optical_length(grid, *medium.grid, s);
        Vec3 through(0), scattered(0);
        RandomSequence numbers(3, 4);
        for (int i = 0; i < estimates; ++i) {
            const double first = numbers.next();
            const FreeFlight f = grid.sample(s, Color(1, 0.5F, 2), first, numbers);
            (f.scatters() ? scattered : through) += Vec3(f.weight) / estimates;
            if (f.scatters()) CHECK(f.distance <= s.length);
        }
        for (int c = 0; c < 3; ++c) {
            const double extinction = medium.extinction()[c], left = std::exp(-length * extinction);
            CHECK_THAT(through[c], WithinAbs(left, 0.02));
            CHECK_THAT(scattered[c],
                       WithinAbs((1 - left) * medium.scattering[c] / extinction, 0.02));
        }
    }
}

TEST_CASE("A ray through a grid is divided as flights say, and passes exactly", "[medium]") {
    const PhysicalMedium medium = cloud(Color(0.5F, 0, 0.1F), Color(0.5F, 0.3F, 0.4F));
    const GridMedium grid(medium);
    const Color throughput(1, 0.5F, 2);
    for (const RaySegment& s : segments()) {
        DensityProfile profile;
        const DividedLight light = grid.divide(s, profile);
        const double length = optical_length(grid, *medium.grid, s);
        RandomSequence numbers(7, 8);
        Vec3 scattered(0), moment(0), expected_moment(0);
        for (int i = 0; i < estimates; ++i) {
            const Vec2 choices(numbers.next(), numbers.next());
            const FreeFlight f = grid.sample(profile, throughput, choices);
            const FreeFlight g = grid.sample(s, throughput, numbers.next(), numbers);
            scattered += Vec3(f.weight) / estimates;
            if (f.scatters()) moment += f.distance * Vec3(f.weight) / estimates;
            if (g.scatters()) expected_moment += g.distance * Vec3(g.weight) / estimates;
        }
        for (int c = 0; c < 3; ++c) {
            const double extinction = medium.extinction()[c], left = std::exp(-length * extinction);
            CHECK_THAT(light.passing[c], WithinAbs(left, 1e-4));
            const double albedo = medium.scattering[c] / extinction;
            CHECK_THAT(light.scattered[c], WithinAbs((1 - left) * albedo, 1e-4));
            CHECK_THAT(scattered[c], WithinAbs((1 - left) * albedo, 5e-3));
            CHECK_THAT(moment[c], WithinAbs(expected_moment[c], 0.02));
        }
    }
}

TEST_CASE("One dense channel of a grid costs no more than some hundred collisions", "[medium]") {
    const PhysicalMedium medium = cloud(Color(1e5F, 0, 0.1F), Color(0, 0.3F, 0.4F));
    const GridMedium grid(medium);
    const Color throughput(1, 0.5F, 2);
    for (const RaySegment& s : segments()) {
        const double length = optical_length(grid, *medium.grid, s);
        Vec3 passed(0), through(0), scattered(0);
        for (int i = 0; i < estimates / 10; ++i) {
            RandomSequence numbers(9, i), same(9, i);
            passed += Vec3(grid.transmittance(s, numbers)) / (estimates / 10);
            const FreeFlight f = grid.sample(s, throughput, numbers.next(), numbers);
            (f.scatters() ? scattered : through) += Vec3(f.weight) / (estimates / 10);
            const double next = numbers.next();
            int drawn = 1;
            while (same.next() != next && drawn < 5000) ++drawn;
            CHECK(drawn < 2000);
        }
        for (int c = 0; c < 3; ++c) {
            const double extinction = medium.extinction()[c], left = std::exp(-length * extinction);
            CHECK_THAT(passed[c], WithinAbs(left, 0.02));
            CHECK_THAT(through[c], WithinAbs(left, 0.03));
            CHECK_THAT(scattered[c],
                       WithinAbs((1 - left) * medium.scattering[c] / extinction, 0.03));
        }
    }
}

TEST_CASE("A grid of one density is a homogeneous medium, without noise", "[medium]") {
    const PhysicalMedium medium = block(2);
    const GridMedium grid(medium);
    const RaySegment inner{{0.3, 0.4, 0.5}, {0, 0, 1}, 0.2};
    RandomSequence numbers(5, 6);
    for (int i = 0; i < 100; ++i) {
        const Color estimate = grid.transmittance(inner, numbers);
        for (int c = 0; c < 3; ++c) {
            CHECK_THAT(estimate[c], WithinAbs(std::exp(-0.4 * medium.extinction()[c]), 1e-6));
        }
    }
}

TEST_CASE("An empty grid lets all pass", "[medium]") {
    const PhysicalMedium medium = block(0);
    const GridMedium grid(medium);
    RandomSequence numbers(5, 6);
    const RaySegment through{{-1, 0.5, 0.5}, {1, 0, 0}, 3};
    CHECK(grid.transmittance(through, numbers) == Color(1));
    const FreeFlight flight = grid.sample(through, Color(1), 0.999, numbers);
    CHECK_FALSE(flight.scatters());
    CHECK(flight.weight == Color(1));
}
