#include "core/medium/homogeneous.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;

namespace {

/// Mean light after sampled flights: transmitted, and scattered before and after half of the
/// distance.
struct Means {
    Vec3 through{0.0}, near{0.0}, far{0.0};
};

constexpr double length = 1.5;
constexpr int flights = 400000;

Means means_of(const PhysicalMedium& medium, const Color& throughput) {
    Means means;
    Random random(11);
    for (int i = 0; i < flights; ++i) {
        const double u = random.uniform(), v = random.uniform();
        const FreeFlight flight =
            sample_homogeneous(medium, {Vec3(0), {0, 0, 1}, length}, throughput, {u, v});
        Vec3& to = !flight.scatters()             ? means.through
                   : flight.distance < length / 2 ? means.near
                                                  : means.far;
        to += Vec3(flight.weight) / flights;
    }
    return means;
}

}  // namespace

TEST_CASE("Flights carry what a medium lets pass and scatters, in each channel", "[medium]") {
    const PhysicalMedium media[] = {{Color(0.1F, 0.2F, 0.3F), Color(0.5F, 1.5F, 4)},
                                    {Color(0), Color(1)},
                                    {Color(0, 2, 1), Color(0.4F, 0, 0)},
                                    {Color(0), Color(0, 1, 0)},
                                    {Color(0.5F), Color(0)}};
    for (const PhysicalMedium& medium : media) {
        for (const Color& throughput : {Color(1), Color(0.9F, 0.1F, 0.3F), Color(0, 2, 0.5F)}) {
            INFO("scattering " << medium.scattering << ", throughput " << throughput);
            const Means means = means_of(medium, throughput);
            for (int c = 0; c < 3; ++c) {
                if (throughput[c] == 0) continue;
                const double extinction = medium.extinction()[c], scattering = medium.scattering[c];
                const auto left = [&](double distance) { return std::exp(-extinction * distance); };
                const double albedo = extinction > 0 ? scattering / extinction : 0;
                CHECK_THAT(means.through[c], WithinAbs(left(length), 0.01));
                CHECK_THAT(means.near[c], WithinAbs(albedo * (1 - left(length / 2)), 0.01));
                CHECK_THAT(means.far[c],
                           WithinAbs(albedo * (left(length / 2) - left(length)), 0.01));
            }
        }
    }
}

TEST_CASE("A medium without end lets nothing pass but what it does not meet", "[medium]") {
    CHECK(transmittance(Color(0, 1, 1e-30F), infinity) == Color(1, 0, 0));
}

TEST_CASE("Flights of white light in a grey medium that absorbs nothing weigh one", "[medium]") {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const double u = random.uniform(), v = random.uniform();
        const FreeFlight flight =
            sample_homogeneous({Color(0), Color(2)}, {Vec3(0), {0, 0, 1}, 1}, Color(1), {u, v});
        for (int c = 0; c < 3; ++c) CHECK_THAT(flight.weight[c], WithinAbs(1, 1e-5));
    }
}
