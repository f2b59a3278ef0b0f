#include "core/color/spectrum.h"

#include <vector>

#include "core/numerics/random.h"
#include "tests/color/near_color.h"

using namespace etalon;

namespace {

using Samples = std::vector<SpectralSample>;

constexpr double exact = 5e-6;  // PBRT v3 sums up 471 floats

}  // namespace

// The numbers expected here are what PBRT v3 computes, built to use RGB.

TEST_CASE("a spectrum has the colour that PBRT v3 gives it") {
    is_near(spectrum_color(Samples{{400, 0}, {500, 1}, {600, 0.5}, {700, 2}}),
            {0.84647274F, 0.760121405F, 0.446026266F}, exact);
    is_near(spectrum_color(Samples{{300, 1}, {900, 1}}), {1.20233166F, 0.946213484F, 0.90734005F},
            exact);
}

TEST_CASE("the order of the samples does not matter") {
    Samples samples;
    Random random(3);
    for (int i = 0; i < 60; ++i) samples.push_back({300 + 10.0 * i, random.uniform()});
    const Color expected = spectrum_color(samples);
    for (int k = 0; k < 20; ++k) {
        for (std::size_t i = samples.size(); i > 1; --i) {
            std::swap(samples[i - 1], samples[random.index(static_cast<unsigned>(i))]);
        }
        CHECK(spectrum_color(samples) == expected);
    }
}

TEST_CASE("a spectrum is constant beyond its samples") {
    is_near(spectrum_color(Samples{{550, 1}}), {1.20233166F, 0.946213484F, 0.90734005F}, exact);
    CHECK(spectrum_color(Samples{{400, 2}, {700, 3}}) ==
          spectrum_color(Samples{{100, 2}, {400, 2}, {700, 3}, {2000, 3}}));
}

TEST_CASE("a spectrum of no samples is black") {
    CHECK(spectrum_color({}) == Color(0.0F));
}

TEST_CASE("two samples at one wavelength are a step") {
    const Color step = spectrum_color(Samples{{500, 1}, {560, 1}, {560, 0}, {600, 0}});
    is_near(step, spectrum_color(Samples{{559, 1}, {560, 0}}), exact);
}

TEST_CASE("a spectrum narrower than the steps of the CIE's table keeps its colour") {
    is_near(spectrum_color(Samples{{552, 0}, {553, 1}, {554, 0}}),
            {0.000153800298F, 0.0131606841F, -0.00158728217F}, 1e-4);
}

TEST_CASE("colours are linear in the spectrum") {
    const Color one = spectrum_color(Samples{{450, 1}, {500, 0.25}, {650, 3}});
    const Color two = spectrum_color(Samples{{450, 8}, {500, 2}, {650, 24}});
    is_near(two, one * 8.0F, 1e-7);
}

TEST_CASE("a black body has the colour that PBRT v3 gives it") {
    const std::vector<std::pair<double, Color>> bodies{
        {800, {4.45539484e-07F, -1.65693219e-08F, -6.78646295e-09F}},
        {1500, {0.0111067249F, 0.00147719425F, -0.000218523535F}},
        {2700, {0.533493757F, 0.221570581F, 0.0529018044F}},
        {3200, {0.856628239F, 0.441664964F, 0.166233897F}},
        {4500, {1.21572876F, 0.883807063F, 0.610254228F}},
        {6500, {0.922218561F, 0.869496405F, 0.915217161F}},
        {10000, {0.385938048F, 0.440290004F, 0.633527696F}},
        {20000, {0.0488255247F, 0.0645664334F, 0.120419487F}}};
    for (const auto& [kelvin, color] : bodies) {
        CAPTURE(kelvin);
        is_near(blackbody_color(kelvin), color,
                kelvin < 1000 ? 4e-5 : 2e-6);  // v3's exponents are floats
    }
}

TEST_CASE("what is no hotter than nothing is black, and what is absurdly hot is finite") {
    CHECK(blackbody_color(0) == Color(0.0F));
    CHECK(blackbody_color(-300) == Color(0.0F));
    CHECK(blackbody_color(nan_value) == Color(0.0F));
    for (const double kelvin : {1e-300, 1.0, 1e9, 1e300}) {
        const Color color = blackbody_color(kelvin);
        CHECK(is_finite(Vec3(color.x, color.y, color.z)));
    }
}

TEST_CASE("CIE coordinates become linear sRGB") {
    is_near(xyz_color({0.3, 0.4, 0.5}), {0.108016208F, 0.480397612F, 0.463732719F}, exact);
    is_near(xyz_color({0.950456, 1, 1.088754}), {1, 1, 1}, 3e-6);  // its white, D65
}
