#include "tests/bsdf/lobe_cases.h"
#include "tests/catch.h"
#include "tests/chi_square.h"

using namespace etalon;
using namespace etalon::test;

namespace {

std::optional<BsdfSample> draw(const Bsdf& bsdf, const Vec3& wo, Random& random) {
    const auto choice = static_cast<float>(random.uniform());
    const double u = random.uniform(), v = random.uniform();
    return bsdf.sample(wo, std::min(choice, std::nextafter(1.0F, 0.0F)), {u, v});
}

/// Returns the probability that samples of the smooth lobes are distributed by `density_factor`
/// times the surface's pdf.
double chi_square(const std::vector<Lobe>& lobes, const Vec3& eye, double density_factor = 1) {
    const Bsdf bsdf = bsdf_of(lobes);
    const Vec3 wo = world(bsdf, eye);
    const SphereSampler sampler = [&](Random& random) -> std::optional<Vec3> {
        const std::optional<BsdfSample> sample = draw(bsdf, wo, random);
        if (!sample || sample->specular) return {};
        return local(bsdf, sample->wi);
    };
    const SphereDensity density = [&](const Vec3& wi) {
        if (shows_backs(lobes, eye, wi)) return 0.0;
        return density_factor * bsdf.evaluate(wo, world(bsdf, wi)).pdf;
    };
    return chi_square_probability(sampler, density, 5);
}

}  // namespace

TEST_CASE("Directions are drawn with the density that is said of them", "[bsdf]") {
    const std::vector<LobeCase> cases = lobe_cases();
    const double significance = sidak(0.01, cases.size() * eyes().size());
    for (const LobeCase& item : cases) {
        for (const Vec3& eye : eyes()) {
            INFO(item.name << ", cosine to the eye " << eye.z);
            CHECK(chi_square(item.lobes, eye) > significance);
        }
    }
}

TEST_CASE("The test of densities finds one that is off by a fiftieth", "[bsdf]") {
    const std::vector<Lobe> white = {LambertReflection{Color(1)}};
    CHECK(chi_square(white, {0, 0, 1}) > 1e-4);
    CHECK(chi_square(white, {0, 0, 1}, 0.98) < 1e-4);
}

TEST_CASE("A sample's value and pdf are those of evaluating its direction", "[bsdf]") {
    Random random(3);
    for (const LobeCase& item : lobe_cases()) {
        const Bsdf bsdf = bsdf_of(item.lobes);
        for (const Vec3& eye : eyes()) {
            INFO(item.name << ", cosine to the eye " << eye.z);
            const Vec3 wo = world(bsdf, eye);
            for (int k = 0; k < 200; ++k) {
                const std::optional<BsdfSample> sample = draw(bsdf, wo, random);
                if (!sample || sample->specular) continue;
                const Evaluation e = bsdf.evaluate(wo, sample->wi);
                CHECK(sample->wi.length() == Approx(1).epsilon(1e-12));
                CHECK(sample->pdf == Approx(e.pdf).epsilon(1e-3));
                CHECK(mean(sample->f) == Approx(mean(e.f)).epsilon(1e-3));
                CHECK(sample->transmission == (eye.z * sample->wi.dot(bsdf.ns()) < 0));
            }
        }
    }
}

TEST_CASE(
    "Diffuse lobes fill the hemisphere of the geometric normal, beyond the other horizon for "
    "lights alone if no lobe of the other side goes there",
    "[bsdf]") {
    const Vec3 ng(0, 0, 1), wo = normalized(Vec3(-0.4, 0.1, 0.5));
    const std::vector<std::vector<Lobe>> cases = {
        {LambertReflection{Color(1)}},
        {OrenNayarReflection(Color(1), 30)},
        {LambertTransmission{Color(1)}},
        {LambertReflection{Color(0.5F)}, LambertTransmission{Color(0.5F)}}};
    // Shading normals with the viewer above and below.
    for (const Vec3& ns : {normalized(Vec3(0.5, 0, 1)), normalized(Vec3(1.5, 0, 1))}) {
        for (const std::vector<Lobe>& lobes : cases) {
            Bsdf bsdf(ng, ns, Vec3(0, 1, 0));
            for (const Lobe& lobe : lobes) bsdf.add(lobe);
            const SphereSampler sampler = [&](Random& random) -> std::optional<Vec3> {
                const std::optional<BsdfSample> sample = draw(bsdf, wo, random);
                REQUIRE(sample);
                const Evaluation e = bsdf.evaluate(wo, sample->wi);
                CHECK(sample->pdf == Approx(e.pdf).epsilon(1e-3));
                CHECK(sample->transmission == (sample->wi.z < 0));
                const bool same_of_ns = sample->wi.dot(ns) * wo.dot(ns) > 0;
                const bool is_between = same_of_ns == sample->transmission;
                CHECK(sample->only_lights == (is_between && lobes.size() == 1));
                return sample->wi;
            };
            const SphereDensity density = [&](const Vec3& wi) { return bsdf.evaluate(wo, wi).pdf; };
            INFO(lobes.size() << " lobes, " << wo.dot(ns));
            CHECK(chi_square_probability(sampler, density, 5) > 1e-3);
        }
    }
}

TEST_CASE("The density's integral is the probability of smooth lobes", "[bsdf]") {
    // A quarter of the light that is not lost goes to the mirror, whatever the direction.
    const Bsdf bsdf =
        bsdf_of({LambertReflection{Color(0.6F)}, SpecularReflection{Color(0.2F), NoFresnel{}}});
    for (const Vec3& eye : eyes()) {
        const Vec3 wo = world(bsdf, eye);
        const double smooth = integral_over_sphere(
            [&](const Vec3& wi) { return bsdf.evaluate(wo, world(bsdf, wi)).pdf; });
        CHECK(smooth == Approx(0.75).epsilon(1e-4));
        const std::optional<BsdfSample> mirrored = bsdf.sample(wo, 0.76F, {0.5, 0.5});
        REQUIRE(mirrored);
        CHECK(mirrored->specular);
        CHECK(mirrored->pdf == Approx(0.25));
    }
}
