#include "tests/catch.h"
#include "tests/material/material_cases.h"

using namespace etalon;
using namespace etalon::test;

namespace {

PhysicalMaterial matte(float kd) {
    return {MatteMaterial{{Color(kd)}, {0}}, {}};
}

PhysicalMaterial mixed(std::uint32_t first, std::uint32_t second, const Color& amount) {
    return {MixedMaterial{first, second, {amount}}, {}};
}

/// What a surface of diffuse lobes reflects of light from above.
Color reflected(const Bsdf& bsdf) {
    return bsdf.evaluate({0, 0, 1}, {0, 0, 1}).f * std::numbers::pi_v<float>;
}

}  // namespace

TEST_CASE("A mix is the sum of two materials by their parts", "[material]") {
    const Bsdf bsdf =
        flat_scattering({matte(0.8F), matte(0.4F), mixed(0, 1, Color(0.25F, 0.5F, 1.5F))});
    CHECK(reflected(bsdf).x == Approx(0.25 * 0.8 + 0.75 * 0.4));
    CHECK(reflected(bsdf).y == Approx(0.6));
    CHECK(reflected(bsdf).z == Approx(1.5 * 0.8));
}

TEST_CASE("Mixes are mixed", "[material]") {
    const Bsdf bsdf = flat_scattering({matte(0.8F), matte(0.4F), mixed(0, 1, Color(0.5F)),
                                       matte(0.1F), mixed(2, 3, Color(0.9F))});
    CHECK(reflected(bsdf).x == Approx(0.9 * 0.6 + 0.1 * 0.1));
}

TEST_CASE("Every kind of lobe is less by its part of a mix", "[material]") {
    const Color grey(0.5F);
    const Vec3 wo(0, 0.6, 0.8), up = normalized(Vec3(0.1, -0.5, 0.8)), down(0.2, -0.4, -0.9);
    for (const PhysicalMaterial& material : std::vector<PhysicalMaterial>{
             {MatteMaterial{{grey}, {30}}, {}},
             {SubstrateMaterial{{grey}, {grey}, rough(0.3F, 0.2F)}, {}},
             {MetalMaterial{{grey}, {grey}, rough(0.3F, 0.2F)}, {}},
             {TranslucentMaterial{{grey}, {grey}, {grey}, {grey}, rough(0.3F, 0.3F)}, {}},
             {GlassMaterial{{grey}, {grey}, {1.5F}, rough(0, 0)}, {}},
             {UberMaterial{{grey}, {grey}, {grey}, {grey}, {grey}, {1.5F}, rough(0.3F, 0.2F)},
              {}}}) {
        INFO("material " << material.kind.index());
        const Bsdf whole = flat_scattering({material});
        const Bsdf part = flat_scattering({material, matte(0), mixed(0, 1, Color(0.25F))});
        CHECK(part.evaluate(wo, up).f.x == Approx(0.25F * whole.evaluate(wo, up).f.x));
        CHECK(part.evaluate(wo, down).f.x == Approx(0.25F * whole.evaluate(wo, down).f.x));
        CHECK(part.albedo(wo).x == Approx(0.25F * whole.albedo(wo).x));
        CHECK(part.lobes().size() == whole.lobes().size());
    }
}

TEST_CASE("A mix of two materials that are alike scatters as each of them", "[material]") {
    const Color grey(0.5F), part(0.7F);
    const Vec3 wo(0, 0.6, 0.8), up = normalized(Vec3(0.1, -0.5, 0.8)), down(0.2, -0.4, -0.9);
    for (const PhysicalMaterial& material : std::vector<PhysicalMaterial>{
             {UberMaterial{{grey}, {grey}, {grey}, {grey}, {part}, {1.5F}, rough(0.3F, 0.2F)}, {}},
             {TranslucentMaterial{{grey}, {grey}, {grey}, {grey}, rough(0.3F, 0.3F)}, {}}}) {
        INFO("material " << material.kind.index());
        const Bsdf one = flat_scattering({material});
        const Bsdf both = flat_scattering({material, material, mixed(0, 1, Color(0.25F))});
        CHECK(both.lobes().size() == 2 * one.lobes().size());
        CHECK(both.evaluate(wo, up).f.x == Approx(one.evaluate(wo, up).f.x));
        CHECK(both.evaluate(wo, down).f.x == Approx(one.evaluate(wo, down).f.x));
        CHECK(both.albedo(wo).x == Approx(one.albedo(wo).x));
    }
}

TEST_CASE("A ring of mixes ends", "[material]") {
    const Bsdf bsdf =
        flat_scattering({matte(0.5F), mixed(2, 0, Color(0.5F)), mixed(1, 1, Color(0.5F))});
    CHECK(reflected(bsdf).x <= 0.5);
    CHECK(reflected(bsdf).x > 0);
}

TEST_CASE("A material mixed with none keeps its own share", "[material]") {
    const Bsdf bsdf = flat_scattering({{NoMaterial{}, {}}, matte(0.5F), mixed(0, 1, Color(0.75F))});
    CHECK(reflected(bsdf).x == Approx(0.125));
}
