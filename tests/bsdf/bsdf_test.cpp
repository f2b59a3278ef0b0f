#include "core/bsdf/bsdf.h"

#include "core/numerics/random.h"
#include "tests/bsdf/lobe_cases.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("Scattering is the same with both directions exchanged", "[bsdf]") {
    Random random(17);
    for (const LobeCase& item : lobe_cases()) {
        if (!item.is_reciprocal) continue;
        const Bsdf bsdf = bsdf_of(item.lobes);
        const double eta = index_of(item.lobes);
        INFO(item.name);
        for (int k = 0; k < 100; ++k) {
            const Vec3 a = random.direction(), b = random.direction();
            if (shows_backs(item.lobes, local(bsdf, a), local(bsdf, b))) continue;
            const double cos_a = a.dot(bsdf.ns()), cos_b = b.dot(bsdf.ns());
            // Radiance divided by the square of the index of refraction is conserved.
            const double spread = cos_a * cos_b > 0 ? 1 : cos_a > 0 ? eta * eta : 1 / (eta * eta);
            const double there = mean(bsdf.evaluate(a, b).f), back = mean(bsdf.evaluate(b, a).f);
            CHECK(there * spread == Approx(back).epsilon(2e-3).margin(1e-5));
        }
    }
}

TEST_CASE("The geometric normal decides reflection or transmission, the shading normal the cosines",
          "[bsdf]") {
    const Vec3 ng(0, 0, 1), ns = normalized(Vec3(1, 0, 1));
    Bsdf bsdf(ng, ns, {0, 1, 0});
    bsdf.add(LambertReflection{Color(1)});
    const Vec3 wo(0, 0, 1);
    const Vec3 below = normalized(Vec3(1, 0, -0.2)), above = normalized(Vec3(-1, 0, 0.2));
    CHECK(bsdf.evaluate(wo, below).f.x == 0);
    CHECK(bsdf.evaluate(wo, below).pdf == 0);
    CHECK(bsdf.evaluate(wo, above).f.x == Approx(1 / std::numbers::pi));
    CHECK(bsdf.evaluate(wo, above).pdf == Approx(-ns.dot(above) / std::numbers::pi));
}

TEST_CASE("A surface from whose side one looks, or without lobes, scatters nothing", "[bsdf]") {
    const Bsdf empty = bsdf_of({}), white = bsdf_of({LambertReflection{Color(1)}});
    const Vec3 up = world(white, {0, 0, 1});
    CHECK_FALSE(empty.sample(up, 0.5F, {0.5, 0.5}));
    CHECK(empty.evaluate(up, up).pdf == 0);
    CHECK_FALSE(empty.is_smooth());

    Bsdf axes({0, 0, 1}, {0, 0, 1}, {1, 0, 0});
    axes.add(LambertReflection{Color(1)});
    CHECK_FALSE(axes.sample({1, 0, 0}, 0.5F, {0.5, 0.5}));
    CHECK(axes.evaluate({1, 0, 0}, {0, 0, 1}).f.x == 0);
}

TEST_CASE("A tangent of no use is replaced", "[bsdf]") {
    const Vec3 ns = normalized(Vec3(1, 2, 3));
    for (const Vec3& tangent : {Vec3(0), ns, -5.0 * ns}) {
        Bsdf bsdf(ns, ns, tangent);
        bsdf.add(LambertReflection{Color(1)});
        const std::optional<BsdfSample> sample = bsdf.sample(ns, 0.5F, {0.3, 0.7});
        REQUIRE(sample);
        CHECK(sample->wi.length() == Approx(1));
        CHECK(sample->pdf == Approx(sample->wi.dot(ns) / std::numbers::pi));
    }
}

TEST_CASE("Lobes are chosen by how much light they scatter", "[bsdf]") {
    const Bsdf bsdf = bsdf_of({SpecularReflection{Color(0.3F, 0.1F, 0.2F), NoFresnel{}},
                               LambertReflection{Color(0)}, SpecularTransmission{Color(0.6F), 1}});
    const Vec3 wo = world(bsdf, {0, 0.6, 0.8});
    for (const float choice : {0.0F, 0.1F, 0.24F, 0.26F, 0.9F, 0.9999999F}) {
        const std::optional<BsdfSample> sample = bsdf.sample(wo, choice, {0.5, 0.5});
        REQUIRE(sample);
        CHECK(sample->transmission == (choice > 0.25F));
        CHECK(sample->pdf == Approx(choice > 0.25F ? 0.75 : 0.25));
    }
}
