#include "core/material/bump.h"

#include "tests/catch.h"
#include "tests/material/material_cases.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Heights a + b u + c v, as a texture.
Textures plane(float a, float b, float c) {
    Textures textures;
    textures.numbers.emplace_back(BilinearTexture<float>{UvMapping{}, a, a + c, a + b, a + b + c});
    return textures;
}

PhysicalMaterial bumpy_matte() {
    return {MatteMaterial{{Color(0.5F)}, {0}}, {0, 0}};
}

Bsdf scattering_of(const Textures& textures, const std::vector<PhysicalMaterial>& all,
                   const MaterialPoint& point) {
    std::vector<std::string> problems;
    return scattering(all.back(), all, TextureValues(textures, problems), point);
}

}  // namespace

TEST_CASE("A surface with heights is shaded as one that is raised", "[material]") {
    const Textures slope = plane(0, 0.5F, -0.25F);
    const Vec3 expected = normalized(Vec3(-0.5, 0.25, 1));
    const Vec3 ns = scattering_of(slope, {bumpy_matte()}, flat_point()).ns();
    CHECK((ns - expected).length() < 1e-3);

    MaterialPoint turned = flat_point();
    turned.ng = turned.ns = {0, 0, -1};
    const Vec3 below = scattering_of(slope, {bumpy_matte()}, turned).ns();
    CHECK((below - normalized(Vec3(-0.5, 0.25, -1))).length() < 1e-3);
}

TEST_CASE("Heights above a curved surface move its points along the turning normal", "[material]") {
    // On a sphere of radius 2 seen from its pole, raised by 1: all derivatives grow by grey.
    MaterialPoint pole = flat_point();
    pole.dpdu = {2, 0, 0};
    pole.dpdv = {0, 2, 0};
    pole.dndu = {1, 0, 0};
    pole.dndv = {0, 1, 0};
    const Textures slope = plane(1, 0.5F, 0);
    const Vec3 ns = scattering_of(slope, {bumpy_matte()},
                                  [&] {
                                      pole.uv = {0, 0};
                                      return pole;
                                  }())
                        .ns();
    CHECK((ns - normalized(Vec3(-0.5 / 3, 0, 1))).length() < 1e-3);
}

TEST_CASE("The first material of a mix gives the bumps", "[material]") {
    const Textures slope = plane(0, 0.5F, 0);
    const PhysicalMaterial flat{MatteMaterial{{Color(0.5F)}, {0}}, {}};
    const PhysicalMaterial first_bumpy{MixedMaterial{0, 1, {Color(0.5F)}}, {}};
    const PhysicalMaterial second_bumpy{MixedMaterial{1, 0, {Color(0.5F)}}, {}};
    const Vec3 raised = scattering_of(slope, {bumpy_matte(), flat, first_bumpy}, flat_point()).ns();
    CHECK((raised - normalized(Vec3(-0.5, 0, 1))).length() < 1e-3);
    CHECK(scattering_of(slope, {bumpy_matte(), flat, second_bumpy}, flat_point()).ns() ==
          Vec3(0, 0, 1));
}

TEST_CASE("Where coordinates have no extent the surface stays as it is", "[material]") {
    MaterialPoint point = flat_point();
    point.dpdu = point.dpdv = Vec3(0);
    CHECK(scattering_of(plane(0, 0, 0), {bumpy_matte()}, point).ns() == Vec3(0, 0, 1));
}

TEST_CASE(
    "Bump map: given a surface whose coordinates span many features, then it has their slopes",
    "[material]") {
    // The noise depends on the position alone, so the extent of u and v is of no importance.
    Textures noise;
    noise.numbers.emplace_back(WrinkledTexture{{}, {8, 0.5F}});
    MaterialPoint small = flat_point({0.3, 0.7});
    MaterialPoint large = small;
    large.dpdu *= 1e4;
    large.dpdv *= 1e4;
    const Vec3 ns = scattering_of(noise, {bumpy_matte()}, small).ns();
    CHECK((ns - Vec3(0, 0, 1)).length() > 0.1);
    CHECK((scattering_of(noise, {bumpy_matte()}, large).ns() - ns).length() < 0.05);
}
