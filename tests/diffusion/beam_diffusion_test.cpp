#include "core/diffusion/beam_diffusion.h"

#include "core/bsdf/fresnel.h"
#include "core/bsdf/fresnel_moments.h"
#include "core/diffusion/diffusion_table.h"
#include "tests/catch.h"

using namespace etalon;

TEST_CASE("Moments of Fresnel's reflectance are its integrals", "[diffusion]") {
    for (const float eta : {0.7F, 0.9F, 1.1F, 1.33F, 1.6F}) {
        CAPTURE(eta);
        double first = 0, second = 0;
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            const double c = (i + 0.5) / steps;
            const double f = dielectric_reflectance(static_cast<float>(c), 1 / eta) / steps;
            first += c * f;
            second += c * c * f;
        }
        // The polynomials were made for this precision.
        CHECK(fresnel_moment1(eta) == Approx(first).margin(0.02));
        CHECK(fresnel_moment2(eta) == Approx(second).margin(0.02));
    }
}

TEST_CASE("Beam diffusion agrees with pbrt-v3", "[diffusion]") {
    CHECK(fresnel_moment1(0.7F) == Approx(0.0405673).epsilon(1e-4));
    CHECK(fresnel_moment2(0.7F) == Approx(0.01768671).epsilon(1e-4));
    CHECK(fresnel_moment1(1.5F) == Approx(0.2982972).epsilon(1e-4));
    CHECK(fresnel_moment2(1.33F) == Approx(0.1085349).epsilon(2e-3));  // sums of large numbers
    const HalfSpace medium{0.9F, 0.3F, 1.4F};
    CHECK(multiple_scattering(medium, 0.01F) == Approx(0.1384949).epsilon(1e-3));
    CHECK(multiple_scattering(medium, 0.5F) == Approx(0.01700332).epsilon(1e-3));
    CHECK(multiple_scattering(medium, 4) == Approx(0.0005630298).epsilon(1e-3));
    CHECK(single_scattering(medium, 0.01F) == Approx(1.884598).epsilon(1e-4));
    CHECK(single_scattering(medium, 0.5F) == Approx(0.004109999).epsilon(1e-4));
}

TEST_CASE("A table gives the effective albedo, and its inverse", "[diffusion]") {
    const DiffusionTable table(0.3F, 1.4F);
    CHECK(table.at(0.5544733F).albedo() == Approx(0.03864217).epsilon(1e-3));
    CHECK(table.at(0.9827393F).albedo() == Approx(0.4683554).epsilon(1e-3));
    CHECK(table.at(1).albedo() == Approx(0.9720896).epsilon(1e-3));
    CHECK(table.albedo_of(0.2F) == Approx(0.9063864).epsilon(1e-4));
    CHECK(table.albedo_of(0.8F) == Approx(1.997446 / 2).epsilon(1e-4));
    CHECK(table.albedo_of(-1) == 0);
    CHECK(table.albedo_of(2) == 1);
    for (const float albedo : {0.1F, 0.6F, 0.93F, 0.999F}) {
        CHECK(table.albedo_of(table.at(albedo).albedo()) == Approx(albedo).epsilon(1e-4));
    }
}

TEST_CASE("Tables of media that hardly are have no number that is none", "[diffusion]") {
    for (const float eta : {0.2F, 0.8F, 1.0F, 3.0F}) {
        for (const float g : {-0.9999F, 0.9999F}) {
            const DiffusionTable table(g, eta);
            for (const float albedo : {0.0F, 0.5F, 1.0F}) {
                for (const float value : table.at(albedo).values) CHECK(std::isfinite(value));
            }
        }
    }
}
