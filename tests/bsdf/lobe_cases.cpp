#include "tests/bsdf/lobe_cases.h"

#include "tests/fourier_tables.h"

namespace etalon::test {
namespace {

const Vec3 tangent = normalized(Vec3(0.3, -0.5, 0.2));

/// Where light comes in, without the factor that makes radiance of what the eye gets.
DiffuseExit exit_of(float index) {
    DiffuseExit exit(index);
    exit.scale(Color(0.999F / (index * index)));  // the moment of the border is no exact one
    return exit;
}

const FourierTable& table() {
    static const FourierTable table = table_of(cosines_of_table(12), 16, glossy_both_sides);
    return table;
}

}  // namespace

std::vector<LobeCase> lobe_cases() {
    const Color grey(0.5F), tinted(0.9F, 0.5F, 0.2F), white(1);
    const TrowbridgeReitz fine(0.1F, 0.1F), even(0.5F, 0.5F), uneven(0.6F, 0.15F),
        coarse(1.6F, 0.9F);
    const DielectricFresnel glass{1.5F}, thinner{1 / 1.5F};
    const ConductorFresnel copper{{0.2F, 0.92F, 1.1F}, {3.9F, 2.45F, 2.14F}};
    return {
        {"Lambert's reflection", {LambertReflection{tinted}}},
        {"Lambert's transmission", {LambertTransmission{tinted}}},
        {"Oren and Nayar's reflection", {OrenNayarReflection(tinted, 30)}},
        {"fine dielectric facets", {MicrofacetReflection{white, fine, glass}}},
        {"facets below a thicker medium", {MicrofacetReflection{grey, even, thinner}}},
        {"uneven metal facets", {MicrofacetReflection{white, uneven, copper}}},
        {"coarse white facets", {MicrofacetReflection{white, coarse, NoFresnel{}}}},
        {"fine refracting facets", {MicrofacetTransmission{white, fine, 1.5F}}},
        {"uneven refracting facets", {MicrofacetTransmission{white, uneven, 1.3F}}},
        {"facets that refract to a thinner medium", {MicrofacetTransmission{grey, even, 1 / 1.5F}}},
        {"base and coat", {FresnelBlend{grey, Color(0.2F), even}}},
        {"dark base and uneven coat", {FresnelBlend{Color(0.01F), tinted, uneven}}},
        {"coat without a base", {FresnelBlend{Color(0), Color(0.05F), fine}}},
        {"hair", {HairScattering({0.3F, 1.55F, Color(0.2F, 0.5F, 1), 0.4F, 0.5F, 2})}, false},
        {"smooth hair at its edge",
         {HairScattering({-0.9F, 1.3F, Color(0.1F), 0.25F, 0.3F, -4})},
         false},
        {"base that is rough and soft", {DisneyBase{grey, 0.9F, 0.5F, 0.4F, 1, Color(0.4F)}}},
        {"gloss between metal and glass", {DisneyGloss{white, uneven, {tinted, 0.6F, 1.4F}}}},
        {"clear facets", {DisneyTransmission{white, uneven, 1.3F}}},
        {"clearcoat", {DisneyClearcoat(1, 0)}},
        {"light from below", {exit_of(1.4F)}, false},
        {"a table", {FourierScattering(table())}, false},
        {"a table under a mirror",
         {FourierScattering(table()), SpecularReflection{grey, glass}},
         false},
        {"transparent gloss",
         {DisneyGloss{white, even, {tinted, 0.2F, 1.5F}}, DisneyTransmission{grey, even, 1.5F},
          DisneyBase{tinted / 4, 0.7F, 1, 0, 1, Color(0)}, DisneyClearcoat(0.5F, 0.3F)}},
        {"rough glass",
         {MicrofacetReflection{white, even, glass}, MicrofacetTransmission{white, even, 1.5F}}},
        {"diffuse under gloss",
         {LambertReflection{grey}, MicrofacetReflection{Color(0.3F), fine, thinner}}},
        {"diffuse and a mirror", {LambertReflection{tinted / 2}, SpecularReflection{grey, glass}}},
        {"both sides, and straight through",
         {LambertReflection{tinted / 2}, LambertTransmission{Color(0.2F)},
          SpecularTransmission{Color(0.3F), 1}}},
    };
}

Bsdf bsdf_of(const std::vector<Lobe>& lobes) {
    const Vec3 normal = normalized(Vec3(-0.2, 0.4, 0.8));
    Bsdf bsdf(normal, normal, tangent);
    for (const Lobe& lobe : lobes) bsdf.add(lobe);
    return bsdf;
}

std::vector<Vec3> eyes() {
    std::vector<Vec3> eyes;
    for (const double cos : {1.0, 0.7, 0.3, 0.1, -0.7, -0.2}) {
        const double sine = std::sqrt(1 - cos * cos);
        eyes.push_back({sine * std::cos(0.7), sine * std::sin(0.7), cos});
    }
    return eyes;
}

double index_of(const std::vector<Lobe>& lobes) {
    const auto index = [](const auto& lobe) -> double {
        if constexpr (
            requires { lobe.eta; } && requires { lobe.facets; })
            return lobe.eta;
        return 1;
    };
    for (const Lobe& lobe : lobes) {
        if (visit_lobe(index, lobe) != 1) return visit_lobe(index, lobe);
    }
    return 1;
}

bool shows_backs(const std::vector<Lobe>& lobes, const Vec3& eye, const Vec3& wi) {
    const double eta = index_of(lobes);
    if (eta == 1 || eye.z * wi.z > 0) return false;
    const Vec3 normal = eye + (eye.z > 0 ? eta : 1 / eta) * wi;
    return normal.z * normal.dot(eye) * eye.z < 0;
}

Vec3 world(const Bsdf& bsdf, const Vec3& local) {
    const Vec3 x = normalized(tangent - bsdf.ns().dot(tangent) * bsdf.ns());
    return local.x * x + local.y * bsdf.ns().cross(x) + local.z * bsdf.ns();
}

Vec3 local(const Bsdf& bsdf, const Vec3& world) {
    const Vec3 x = normalized(tangent - bsdf.ns().dot(tangent) * bsdf.ns());
    return {world.dot(x), world.dot(bsdf.ns().cross(x)), world.dot(bsdf.ns())};
}

}  // namespace etalon::test
