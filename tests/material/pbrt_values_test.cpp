// Compares values with those that PBRT version 3's code computes for the same materials.
#include <array>

#include "tests/catch.h"
#include "tests/chi_square.h"
#include "tests/material/material_cases.h"

using namespace etalon;
using namespace etalon::test;

namespace {

struct Directions {
    Vec3 wo, wi;
};

/// From above to above, from above to below, from below to below, from below to above.
const std::array<Directions, 4> directions{{{{0.48, 0.36, 0.8}, {-0.6, 0, 0.8}},
                                            {{0.48, 0.36, 0.8}, {-0.36, -0.48, -0.8}},
                                            {{0.28, 0, -0.96}, {-0.48, -0.64, -0.6}},
                                            {{0.28, 0, -0.96}, {-0.6, 0.48, 0.64}}}};

using Values = std::array<Color, 4>;

/// Checks the values of the smooth lobes of the last of `all`.
void check_values(const std::vector<PhysicalMaterial>& all, const Values& expected, double v = 0.5,
                  double epsilon = 1e-4) {
    const Bsdf bsdf = flat_scattering(all, {0.25, v});
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const Color f = bsdf.evaluate(directions[k].wo, directions[k].wi).f;
        INFO("material " << all.back().kind.index() << ", directions " << k);
        CHECK(f.x == Approx(expected[k].x).epsilon(epsilon));
        CHECK(f.y == Approx(expected[k].y).epsilon(epsilon));
        CHECK(f.z == Approx(expected[k].z).epsilon(epsilon));
    }
}

const ColorSlot kd{{0.8F, 0.4F, 0.2F}}, ks{{0.3F, 0.5F, 0.7F}}, kr{{0.9F, 0.6F, 0.3F}},
    kt{{0.2F, 0.5F, 0.8F}}, part{{0.25F, 0.5F, 0.75F}}, copper_eta{{0.2F, 0.924F, 1.102F}},
    copper_k{{3.912F, 2.452F, 2.142F}};
const NumberSlot eta{1.4F};
const Color none(0);

PhysicalMaterial matte() {
    return {MatteMaterial{kd, {30}}, {}};
}

PhysicalMaterial glass(bool remap) {
    return {GlassMaterial{kr, kt, eta, rough(0.2F, 0.4F, remap)}, {}};
}

DisneyMaterial plain_disney() {
    DisneyMaterial m;
    m.color = kd;
    m.eta = {1.5F};
    m.roughness = m.sheen_tint = {0.5F};
    m.clearcoat_gloss = m.diffuse_transmission = {1};
    return m;
}

DisneyMaterial glossy_disney() {
    DisneyMaterial m = plain_disney();
    m.metallic = {0.6F};
    m.eta = {1.4F};
    m.roughness = {0.4F};
    m.specular_tint = {0.7F};
    m.anisotropic = {0.8F};
    m.sheen = {0.9F};
    m.sheen_tint = {0.3F};
    m.clearcoat = {0.8F};
    m.clearcoat_gloss = {0.2F};
    return m;
}

DisneyMaterial clear_disney() {
    DisneyMaterial m = plain_disney();
    m.metallic = {0.2F};
    m.eta = {1.4F};
    m.roughness = {0.6F};
    m.specular_transmission = {0.7F};
    m.anisotropic = {0.5F};
    return m;
}

DisneyMaterial thin_disney() {
    DisneyMaterial m = plain_disney();
    m.thin = true;
    m.eta = {1.4F};
    m.roughness = {0.6F};
    m.specular_transmission = {0.4F};
    m.flatness = {0.3F};
    m.diffuse_transmission = {0.8F};
    m.sheen = {0.5F};
    return m;
}

/// Checks the light that a material reflects and transmits under uniform illumination to each of
/// three directions.
void check_energy(const PhysicalMaterial& material, const std::array<Color, 3>& expected) {
    const Bsdf bsdf = flat_scattering({material});
    const std::array<Vec3, 3> eyes{{{0, 0, 1}, {0.6, 0, 0.8}, {0.48, 0.8, 0.36}}};
    for (std::size_t k = 0; k < eyes.size(); ++k) {
        for (int channel = 0; channel < 3; ++channel) {
            const double power = integral_over_sphere([&](const Vec3& wi) {
                return bsdf.evaluate(eyes[k], wi).f[channel] * std::abs(wi.z);
            });
            INFO("direction " << k << ", channel " << channel);
            CHECK(power == Approx(expected[k][channel]).epsilon(1e-3));
        }
    }
}

}  // namespace

TEST_CASE("Values of opaque materials are PBRT's", "[material]") {
    const Color diffuse(0.19687F, 0.0984352F, 0.0492176F);
    check_values({matte()}, {diffuse, none, diffuse, none});
    check_values({{PlasticMaterial{kd, ks, rough(0.2F, 0.2F)}, {}}},
                 {Color(0.269379F, 0.151876F, 0.098035F), none,
                  Color(0.256548F, 0.130491F, 0.0680959F), none});
    check_values({{PlasticMaterial{kd, ks, rough(0.2F, 0.2F, true)}, {}}},
                 {Color(0.259878F, 0.136041F, 0.0758665F), none,
                  Color(0.256911F, 0.131095F, 0.0689421F), none});
    check_values({{MetalMaterial{copper_eta, copper_k, rough(0.2F, 0.4F)}, {}}},
                 {Color(0.764126F, 0.497225F, 0.410927F), none,
                  Color(0.362124F, 0.235615F, 0.194563F), none});
    check_values({{MetalMaterial{copper_eta, copper_k, rough(0.2F, 0.4F, true)}, {}}},
                 {Color(0.148598F, 0.0966944F, 0.0799122F), none,
                  Color(0.144102F, 0.0937598F, 0.0774234F), none});
    check_values({{SubstrateMaterial{kd, ks, rough(0.2F, 0.4F)}, {}}},
                 {Color(0.423093F, 0.463364F, 0.576145F), none,
                  Color(0.25841F, 0.203246F, 0.216308F), none});
    check_values({{SubstrateMaterial{kd, ks, rough(0.2F, 0.4F, true)}, {}}},
                 {Color(0.236902F, 0.15312F, 0.141846F), none,
                  Color(0.215133F, 0.131125F, 0.115344F), none});
}

TEST_CASE("Values of materials that let light through are PBRT's", "[material]") {
    check_values(
        {glass(false)},
        {Color(0.0218627F, 0.0145751F, 0.00728756F), Color(0.351437F, 0.878592F, 1.40575F),
         Color(0.0136037F, 0.00906917F, 0.00453458F), Color(0.00750483F, 0.0187621F, 0.0300193F)});
    check_values(
        {glass(true)},
        {Color(0.00425159F, 0.00283439F, 0.0014172F), Color(0.463928F, 1.15982F, 1.85571F),
         Color(0.00541342F, 0.00360895F, 0.00180447F), Color(0.0101466F, 0.0253665F, 0.0405864F)});
    check_values(
        {{TranslucentMaterial{kd, ks, kr, kt, rough(0.2F, 0.2F)}, {}}},
        {Color(0.23605F, 0.0840244F, 0.0244396F), Color(0.0652231F, 0.123218F, 0.184336F),
         Color(0.23174F, 0.0792355F, 0.0210874F), Color(0.0535299F, 0.0744965F, 0.075199F)});
    check_values({{UberMaterial{kd, ks, kr, kt, part, eta, rough(0.2F, 0.4F)}, {}}},
                 {Color(0.0654839F, 0.0697349F, 0.0604997F), none,
                  Color(0.0647956F, 0.0674408F, 0.055682F), none});
    check_values(
        {matte(), glass(true), {MixedMaterial{0, 1, part}, {}}},
        {Color(0.0524063F, 0.0506348F, 0.0372675F), Color(0.347946F, 0.579911F, 0.463928F),
         Color(0.0532777F, 0.0510221F, 0.0373643F), Color(0.00760994F, 0.0126832F, 0.0101466F)});
}

TEST_CASE("Rough diffuse surfaces look brighter towards the light, as PBRT's do", "[material]") {
    const Bsdf bsdf = flat_scattering({matte()});
    const Vec3 wo(0.48, 0.36, 0.8);
    CHECK(bsdf.evaluate(wo, {0.6, 0, 0.8}).f.x == Approx(0.2279278).epsilon(1e-5));
    CHECK(bsdf.evaluate(wo, {0.48, 0.64, 0.6}).f.z == Approx(0.06164058).epsilon(1e-5));
}

TEST_CASE("Values of hair are PBRT's", "[material]") {
    // Its ten terms of Bessel's function are too few for the larger arguments.
    constexpr double series = 4e-3;
    HairMaterial hair{
        HairPigment::absorption, {Color(0.1F, 0.5F, 1)}, {}, {}, {1.4F}, {0.5F}, {0.6F}, {5}};
    check_values(
        {{hair, {}}},
        {Color(0.0190241F, 0.00718435F, 0.00371329F), Color(0.739287F, 0.325401F, 0.116714F),
         Color(0.0274103F, 0.0231641F, 0.0214702F), Color(0.657866F, 0.300368F, 0.112758F)},
        0.7, series);
    hair = {
        HairPigment::reflectance, {Color(0.8F, 0.4F, 0.2F)}, {}, {}, {1.55F}, {0.6F}, {0.4F}, {2}};
    check_values(
        {{hair, {}}},
        {Color(0.010475F, 0.00975616F, 0.00839108F), Color(0.170181F, 0.162341F, 0.146235F),
         Color(0.0114441F, 0.010465F, 0.00858823F), Color(0.0138234F, 0.0132029F, 0.0119358F)},
        0.2, series);
    hair = {HairPigment::melanin, {Color(0)}, {0.3F}, {0.4F}, {1.55F}, {0.5F}, {0.3F}, {2}};
    check_values({{hair, {}}},
                 {Color(0.0142517F, 0.0125501F, 0.0111545F), Color(1.6628F, 1.16631F, 0.441432F),
                  Color(0.000673768F, 0.000544844F, 0.000453713F),
                  Color(0.028145F, 0.0199461F, 0.00778741F)},
                 0.5, series);
}

TEST_CASE("Values of the disney material are PBRT's", "[material]") {
    check_values({{plain_disney(), {}}}, {Color(0.280622F, 0.153283F, 0.0896141F), none,
                                          Color(0.267331F, 0.139719F, 0.075913F), none});
    check_values({{glossy_disney(), {}}}, {Color(0.130123F, 0.0672836F, 0.0358638F), none,
                                           Color(0.11082F, 0.0598433F, 0.0343549F), none});
    check_values(
        {{clear_disney(), {}}},
        {Color(0.0815579F, 0.0456074F, 0.0276322F), Color(0.162801F, 0.115117F, 0.0814002F),
         Color(0.0891317F, 0.0584597F, 0.0431237F), Color(0.0083657F, 0.00591544F, 0.00418285F)});
    check_values(
        {{thin_disney(), {}}},
        {Color(0.100983F, 0.058103F, 0.0366631F), Color(0.136924F, 0.075724F, 0.0429971F),
         Color(0.0967909F, 0.0531785F, 0.0313723F), Color(0.103491F, 0.0520832F, 0.0262805F)});
}

// The means of images of a plane under uniform illumination, of 4 million samples each, with errors
// below 5e-5. The last value of the clear one is the integral of PBRT's values, since at grazing
// angles its samples lose 0.6 % of them.
TEST_CASE("The disney material scatters as much light as PBRT's", "[material]") {
    check_energy({plain_disney(), {}},
                 {Color(0.84181F, 0.43943F, 0.23824F), Color(0.84523F, 0.4433F, 0.24234F),
                  Color(0.90298F, 0.49677F, 0.29367F)});
    check_energy({glossy_disney(), {}},
                 {Color(0.61438F, 0.3167F, 0.16786F), Color(0.61073F, 0.31644F, 0.1693F),
                  Color(0.66572F, 0.38484F, 0.2444F)});
    check_energy({clear_disney(), {}},
                 {Color(0.54816F, 0.34842F, 0.22993F), Color(0.54187F, 0.34479F, 0.2281F),
                  Color(0.55059F, 0.36035F, 0.24877F)});
    check_energy({thin_disney(), {}},
                 {Color(0.8F, 0.44844F, 0.2619F), Color(0.81165F, 0.45585F, 0.26725F),
                  Color(0.89055F, 0.50873F, 0.30821F)});
}
