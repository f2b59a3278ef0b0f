#include "tests/bsdf/lobe_cases.h"
#include "tests/catch.h"
#include "tests/chi_square.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Power over incident power that a surface scatters of light from `eye`, by its smooth lobes: the
/// integral of f |cos|, with what passes a border gathered where light is spread eta^2 wider.
/// Facets that turn their back to the eye are counted or not.
double scattered_power(const std::vector<Lobe>& lobes, const Vec3& eye, bool with_backs) {
    const Bsdf bsdf = bsdf_of(lobes);
    const Vec3 wo = world(bsdf, eye);
    const double beyond = eye.z > 0 ? index_of(lobes) : 1 / index_of(lobes);
    return integral_over_sphere([&](const Vec3& wi) {
        if (!with_backs && shows_backs(lobes, eye, wi)) return 0.0;
        const double spread = wi.z * eye.z < 0 ? beyond * beyond : 1;
        return mean(bsdf.evaluate(wo, world(bsdf, wi)).f) * std::abs(wi.z) * spread;
    });
}

}  // namespace

TEST_CASE("No surface scatters more light than it gets", "[bsdf]") {
    for (const LobeCase& item : lobe_cases()) {
        for (const Vec3& eye : eyes()) {
            INFO(item.name << ", cosine to the eye " << eye.z);
            const double power = scattered_power(item.lobes, eye, true);
            CHECK(power > 0);
            CHECK(power < 1.0001);
        }
    }
}

TEST_CASE("A hair that absorbs nothing scatters all light", "[bsdf]") {
    for (const float across : {-0.95F, -0.4F, 0.0F, 0.7F}) {
        for (const auto& [m, n] : {std::pair(0.3F, 0.3F), std::pair(0.27F, 0.5F),
                                   std::pair(0.6F, 0.2F), std::pair(0.9F, 0.9F)}) {
            const std::vector<Lobe> white = {HairScattering({across, 1.55F, Color(0), m, n, 2})};
            INFO("at " << across << " of the width, roughness " << m << " and " << n);
            CHECK(scattered_power(white, {0.3, -0.4, std::sqrt(0.75)}, true) ==
                  Approx(1).epsilon(1e-3));
        }
    }
}

TEST_CASE("A hair that absorbs nothing scatters all light if its index is below that outside",
          "[bsdf]") {
    for (const float index : {0.9F, 0.5F, 0.3F, 0.1F, 0.0F}) {
        for (const float across : {-0.95F, 0.0F, 0.7F}) {
            const std::vector<Lobe> white = {
                HairScattering({across, index, Color(0), 0.3F, 0.5F, 2})};
            INFO("index " << index << ", at " << across << " of the width");
            CHECK(scattered_power(white, {0.3, -0.4, std::sqrt(0.75)}, true) ==
                  Approx(1).epsilon(1e-3));
        }
    }
}

TEST_CASE("Light from below comes through borders of usual indices, and is never negative",
          "[bsdf]") {
    for (const float index : {0.0F, 0.3F, 0.5F, 1.0F, 1.33F, 1.5F, 2.0F, 5.0F}) {
        CAPTURE(index);
        const double power = scattered_power({DiffuseExit(index)}, {0, 0, 1}, true);
        CHECK(power >= 0);
        if (index >= 1 && index <= 2) CHECK(power == Approx(index * index).epsilon(0.01));
    }
}

TEST_CASE("Samples carry the light that the surface scatters", "[bsdf]") {
    Random random(11);
    for (const LobeCase& item : lobe_cases()) {
        const Bsdf bsdf = bsdf_of(item.lobes);
        for (const Vec3& eye : eyes()) {
            const Vec3 wo = world(bsdf, eye);
            constexpr int samples = 20000;
            double sum = 0, squares = 0;
            for (int k = 0; k < samples; ++k) {
                const auto choice = static_cast<float>(random.uniform(0, 0.9999));
                const double u = random.uniform(), v = random.uniform();
                const std::optional<BsdfSample> s = bsdf.sample(wo, choice, {u, v});
                if (!s || s->specular) continue;
                const double power =
                    mean(s->f) * std::abs(s->wi.dot(bsdf.ns())) / s->pdf * s->eta * s->eta;
                sum += power;
                squares += power * power;
            }
            const double average = sum / samples;
            const double error =
                std::sqrt(std::max(0.0, squares / samples - average * average) / samples);
            INFO(item.name << ", cosine to the eye " << eye.z << ", error " << error);
            CHECK(std::abs(average - scattered_power(item.lobes, eye, false)) < 4.5 * error + 1e-4);
        }
    }
}
