#include "core/material/material.h"

#include <typeinfo>

#include "core/scene/most_lobes.h"
#include "tests/catch.h"
#include "tests/material/material_cases.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// The kinds of a surface's lobes, in order.
template <class... Kinds>
bool has_lobes(const Bsdf& bsdf) {
    const auto lobes = bsdf.lobes();
    if (lobes.size() != sizeof...(Kinds)) return false;
    [[maybe_unused]] std::size_t k = 0;
    return (std::holds_alternative<Kinds>(lobes[k++]) && ...);
}

template <class... Kinds, class Material>
void check_lobes(const Material& material) {
    INFO(typeid(material).name());
    CHECK(has_lobes<Kinds...>(flat_scattering_of(material)));
}

const Color grey(0.5F), black(0), white(1);

}  // namespace

TEST_CASE("Materials have the lobes that PBRT gives them", "[material]") {
    using R = MicrofacetReflection;
    using T = MicrofacetTransmission;
    const ColorSlot c{grey}, none{black};
    const Roughness smooth = rough(0, 0), even = rough(0.1F, 0.1F);
    const NumberSlot eta{1.5F};
    check_lobes<LambertReflection>(MatteMaterial{c, {0}});
    check_lobes<OrenNayarReflection>(MatteMaterial{c, {20}});
    check_lobes<>(MatteMaterial{none, {20}});
    check_lobes<LambertReflection, R>(PlasticMaterial{c, c, even});
    check_lobes<R>(PlasticMaterial{none, c, even});
    check_lobes<LambertReflection>(PlasticMaterial{c, none, even});
    check_lobes<SpecularReflection>(MirrorMaterial{c});
    check_lobes<>(MirrorMaterial{none});
    check_lobes<R>(MetalMaterial{c, c, smooth});
    check_lobes<FresnelBlend>(SubstrateMaterial{none, c, even});
    check_lobes<>(SubstrateMaterial{none, none, even});
    check_lobes<FresnelSpecular>(GlassMaterial{none, c, eta, smooth});
    check_lobes<R, T>(GlassMaterial{c, c, eta, rough(0, 0.1F)});
    check_lobes<T>(GlassMaterial{none, c, eta, rough(0.1F, 0)});
    check_lobes<>(GlassMaterial{none, none, eta, smooth});
    check_lobes<LambertReflection, LambertTransmission, R, T>(
        TranslucentMaterial{c, c, c, c, even});
    check_lobes<LambertTransmission, T>(TranslucentMaterial{c, c, none, c, even});
    check_lobes<>(NoMaterial{});
}

TEST_CASE("A material has as many lobes as are counted for it, where all that it names is there",
          "[material]") {
    const ColorSlot c{grey};
    const NumberSlot some{0.5F}, eta{1.5F};
    const Roughness even = rough(0.1F, 0.1F);
    const GlassMaterial glass{c, c, eta, even};
    const auto check_count = []<class Kind>(const Kind& material) {
        INFO(typeid(material).name());
        CHECK(flat_scattering_of(material).lobes().size() == most_lobes<Kind>);
    };
    check_count(MatteMaterial{c, {20}});
    check_count(PlasticMaterial{c, c, even});
    check_count(MirrorMaterial{c});
    check_count(glass);
    check_count(MetalMaterial{c, c, even});
    check_count(UberMaterial{c, c, c, c, c, eta, even});
    check_count(TranslucentMaterial{c, c, c, c, even});
    check_count(SubstrateMaterial{c, c, even});
    check_count(SubsurfaceMaterial{glass, c, c});
    check_count(KdSubsurfaceMaterial{glass, c, c});
    check_count(HairMaterial{HairPigment::reflectance, c, {1}, {1}, eta, some, some, {2}});
    check_count(NoMaterial{});
    DisneyMaterial disney{c, some, eta, some, some, some, some, some, some, some, some, some, some};
    disney.scatter_distance = c;
    check_count(disney);
    disney.thin = true;
    check_count(disney);
}

TEST_CASE("An uber surface has a lobe for each of its colours, all less by its opacity",
          "[material]") {
    const Color part(0.25F, 0.5F, 1);
    const Bsdf solid = flat_scattering_of(
        UberMaterial{{grey}, {grey}, {black}, {black}, {white}, {1.5F}, rough(0.1F, 0.1F)});
    CHECK(has_lobes<LambertReflection, MicrofacetReflection>(solid));

    const Bsdf clear = flat_scattering_of(
        UberMaterial{{grey}, {grey}, {grey}, {grey}, {part}, {1.5F}, rough(0.1F, 0.1F)});
    REQUIRE(has_lobes<SpecularTransmission, LambertReflection, MicrofacetReflection,
                      SpecularReflection, SpecularTransmission>(clear));
    const auto& through = std::get<SpecularTransmission>(clear.lobes()[0]);
    CHECK(through.transmittance == Color(0.75F, 0.5F, 0));
    CHECK(through.eta == 1);
    CHECK(std::get<LambertReflection>(clear.lobes()[1]).reflectance == part * grey);
    CHECK(std::get<SpecularTransmission>(clear.lobes()[4]).transmittance == part * grey);
    CHECK(std::get<SpecularTransmission>(clear.lobes()[4]).eta == 1.5F);
}

TEST_CASE("Colours below 0 count as 0, and such above 1 as they are", "[material]") {
    const Bsdf odd = flat_scattering_of(MatteMaterial{{Color(-1, 0.5F, 3)}, {-5}});
    REQUIRE(has_lobes<LambertReflection>(odd));
    CHECK(std::get<LambertReflection>(odd.lobes()[0]).reflectance == Color(0, 0.5F, 3));
}

TEST_CASE("Roughness is taken as it stands or as an even scale of appearance", "[material]") {
    const auto alpha = [](const Roughness& roughness) {
        const Bsdf metal = flat_scattering_of(MetalMaterial{{grey}, {white}, roughness});
        const auto& facets = std::get<MicrofacetReflection>(metal.lobes()[0]).facets;
        return Vec2(facets.stretched({1, 0, 0}), facets.stretched({0, 1, 0}));
    };
    CHECK(alpha(rough(0.25F, 0.5F)) == Vec2(0.25F, 0.5F));
    CHECK(alpha(rough(0, 7)) == Vec2(0.001F, 7));
    // What PBRT's polynomial gives for these.
    CHECK(alpha(rough(1, 1, true)).x == Approx(1.62142));
    CHECK(alpha(rough(0.1F, 0.01F, true)).x == Approx(0.46176));
    CHECK(alpha(rough(0.1F, 0.01F, true)).y == Approx(0.138924));
    CHECK(alpha(rough(0, 0, true)).x == alpha(rough(0.001F, 0.001F, true)).x);
}
