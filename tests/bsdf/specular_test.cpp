#include <limits>

#include "tests/bsdf/lobe_cases.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns the power of a sample relative to that of its direction.
double carried(const Bsdf& bsdf, const BsdfSample& s) {
    return mean(s.f) * std::abs(s.wi.dot(bsdf.ns())) / s.pdf * s.eta * s.eta;
}

}  // namespace

TEST_CASE("A white mirror and white glass lose no light", "[bsdf]") {
    const Bsdf mirror = bsdf_of({SpecularReflection{Color(1), NoFresnel{}}});
    const Bsdf glass = bsdf_of({FresnelSpecular{Color(1), Color(1), 1.5F}});
    for (const Vec3& eye : eyes()) {
        INFO("cosine to the eye " << eye.z);
        for (const Bsdf* bsdf : {&mirror, &glass}) {
            const Vec3 wo = world(*bsdf, eye);
            CHECK_FALSE(bsdf->is_smooth());
            CHECK(mean(bsdf->albedo(wo)) == Approx(1));
            CHECK(bsdf->evaluate(wo, wo).pdf == 0);
            for (const double u : {0.0001, 0.3, 0.9999}) {
                const std::optional<BsdfSample> sample = bsdf->sample(wo, 0.5F, {u, 0.5});
                REQUIRE(sample);
                CHECK(sample->specular);
                CHECK(carried(*bsdf, *sample) == Approx(1));
            }
        }
    }
}

TEST_CASE("Conductors of indices beyond all others mirror all light", "[bsdf]") {
    constexpr float largest = std::numeric_limits<float>::max();
    for (const float much : {1e8F, 1e10F, 1e20F, largest}) {
        for (const auto& [eta, k] : {std::pair(0.0F, much), std::pair(1.0F, much),
                                     std::pair(much, 0.0F), std::pair(much, much)}) {
            const Bsdf metal =
                bsdf_of({SpecularReflection{Color(1), ConductorFresnel{Color(eta), Color(k)}}});
            for (const Vec3& eye : eyes()) {
                INFO("eta " << eta << ", k " << k << ", cosine to the eye " << eye.z);
                CHECK(mean(metal.albedo(world(metal, eye))) == Approx(1));
            }
        }
    }
}

TEST_CASE("Glass reflects and refracts by the laws of mirrors and of Snell", "[bsdf]") {
    const Bsdf glass = bsdf_of({FresnelSpecular{Color(1), Color(1), 1.5F}});
    for (const Vec3& eye : eyes()) {
        const Vec3 wo = world(glass, eye);
        const double beyond = eye.z > 0 ? 1.5F : 1 / 1.5F;
        const std::optional<BsdfSample> reflected = glass.sample(wo, 0, {0, 0});
        REQUIRE(reflected);
        CHECK_FALSE(reflected->transmission);
        CHECK((local(glass, reflected->wi) - Vec3(-eye.x, -eye.y, eye.z)).length() < 1e-14);

        const std::optional<BsdfSample> other = glass.sample(wo, 0, {0.999999, 0});
        REQUIRE(other);
        const bool total = std::hypot(eye.x, eye.y) > beyond;
        CHECK(other->transmission == !total);
        if (total) continue;
        const Vec3 wi = local(glass, other->wi);
        CHECK(wi.z * eye.z < 0);
        CHECK(beyond * wi.x == Approx(-eye.x).margin(1e-6));
        CHECK(beyond * wi.y == Approx(-eye.y).margin(1e-6));
        CHECK(other->eta == Approx(beyond));
    }
}

TEST_CASE("What lets light straight through leaves its direction as it is, to the last bits",
          "[bsdf]") {
    const Bsdf clear = bsdf_of({SpecularTransmission{Color(0.25F, 0.5F, 1), 1}});
    for (const Vec3& eye : eyes()) {
        const Vec3 wo = world(clear, eye);
        const std::optional<BsdfSample> sample = clear.sample(wo, 0.3F, {0.1, 0.2});
        REQUIRE(sample);
        CHECK((sample->wi + wo).length() < 1e-15);
        CHECK(sample->eta == 1);
        CHECK(sample->transmission);
        const double cos = std::abs(eye.z);
        CHECK(sample->f.x * cos == Approx(0.25));
        CHECK(sample->f.z * cos == Approx(1));
    }
}

TEST_CASE("Only transmission is left where nothing reflects", "[bsdf]") {
    const Bsdf glass = bsdf_of({FresnelSpecular{Color(0), Color(1), 1.5F}});
    const Vec3 wo = world(glass, {0, 0.6, 0.8});
    const std::optional<BsdfSample> sample = glass.sample(wo, 0, {0, 0});
    REQUIRE(sample);
    CHECK(sample->transmission);
    CHECK(sample->pdf == 1);
    CHECK_FALSE(glass.sample(world(glass, {0, 0.9, -std::sqrt(0.19)}), 0, {0.5, 0}));
}
