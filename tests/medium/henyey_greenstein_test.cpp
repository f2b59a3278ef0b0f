#include "core/medium/henyey_greenstein.h"

#include "tests/catch.h"
#include "tests/chi_square.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr float cosines[] = {-0.95F, -0.5F, -1e-3F, 0, 5e-5F, 2e-4F, 0.3F, 0.7F, 0.98F};

const Vec3 ways[] = {{0, 0, 1}, normalized(Vec3(1, -2, 0.5)), {0, 0, -1}};

}  // namespace

TEST_CASE("Henyey and Greenstein's directions have their density", "[medium]") {
    for (const float g : cosines) {
        const HenyeyGreenstein phase(g);
        for (const Vec3& way : ways) {
            INFO("g " << g << ", way " << way);
            const SphereSampler sample = [&](Random& random) -> std::optional<Vec3> {
                const double u = random.uniform(), v = random.uniform();
                return phase.sample(way, {u, v});
            };
            const SphereDensity density = [&](const Vec3& wi) { return phase.value(way.dot(wi)); };
            CHECK(chi_square_probability(sample, density, 7) >
                  sidak(0.01, std::size(cosines) * std::size(ways)));
        }
    }
}

TEST_CASE("The mean cosine of Henyey and Greenstein's phase function is g", "[medium]") {
    for (const float g : cosines) {
        INFO("g " << g);
        const HenyeyGreenstein phase(g);
        double sum = 0, moment = 0;
        constexpr int parts = 2000000;
        for (int i = 0; i < parts; ++i) {
            const double cosine = -1 + (2 * i + 1.0) / parts;
            const double share = phase.value(cosine) * 4 * std::numbers::pi / parts;
            sum += share;
            moment += cosine * share;
        }
        CHECK_THAT(sum, WithinAbs(1, 1e-5));
        CHECK_THAT(moment, WithinAbs(g, 1e-5));
    }
}
