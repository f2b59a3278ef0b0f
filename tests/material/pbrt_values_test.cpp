// Values against those that PBRT version 3's own code computed for the same materials.
#include <array>

#include "tests/catch.h"
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
void check_values(const std::vector<PhysicalMaterial>& all, const Values& expected) {
    const Bsdf bsdf = flat_scattering(all);
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const Color f = bsdf.evaluate(directions[k].wo, directions[k].wi).f;
        INFO("material " << all.back().kind.index() << ", directions " << k);
        CHECK(f.x == Approx(expected[k].x).epsilon(1e-4));
        CHECK(f.y == Approx(expected[k].y).epsilon(1e-4));
        CHECK(f.z == Approx(expected[k].z).epsilon(1e-4));
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
