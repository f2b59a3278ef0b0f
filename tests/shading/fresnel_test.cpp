#include "core/shading/fresnel.h"

#include <cmath>

#include "tests/catch.h"

using namespace etalon;

TEST_CASE("At normal incidence the reflectance is ((n-1)/(n+1))^2", "[shading]") {
    for (const double n : {1.0, 1.15, 1.33, 1.5, 2.4}) {
        const double expected = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
        CHECK(fresnel_dielectric(1 / n, 1).reflectance == Approx(expected).margin(1e-15));
        CHECK(fresnel_dielectric(n, 1).reflectance == Approx(expected).margin(1e-15));
        CHECK(fresnel_schlick(1 / n, 1).reflectance == Approx(expected).margin(1e-15));
    }
}

TEST_CASE("Schlick's reflectance is r0 + (1 - r0) (1 - c)^5, c in the thinner medium",
          "[shading]") {
    // r0 of an index of 1.5 is 0.04: 0.04 + 0.96 / 32 is 0.07, on both sides of the border.
    CHECK(fresnel_schlick(1 / 1.5, 0.5).reflectance == Approx(0.07));
    const double inside = std::sqrt(1 - 0.75 / 2.25);
    CHECK(fresnel_schlick(1.5, inside).reflectance == Approx(0.07));
    CHECK(fresnel_schlick(1.5, inside).cos_refracted == Approx(0.5));
    CHECK(fresnel_schlick(1 / 1.5, 0.0).reflectance == Approx(1));
    CHECK(fresnel_schlick(1.5, 0.7).total);
}

TEST_CASE("The reflectance is the same from both sides of a border", "[shading]") {
    const double eta = 1 / 1.5;
    for (double cosine = 0.05; cosine < 1; cosine += 0.05) {
        const FresnelTerms in = fresnel_dielectric(eta, cosine);
        const FresnelTerms out = fresnel_dielectric(1 / eta, in.cos_refracted);
        CHECK(out.reflectance == Approx(in.reflectance));
        CHECK(out.cos_refracted == Approx(cosine));
    }
}

TEST_CASE("At Brewster's angle only the perpendicular part is reflected", "[shading]") {
    const double n = 1.5, cosine = std::cos(std::atan(n));
    const double perpendicular = std::pow((n * n - 1) / (n * n + 1), 2);
    CHECK(fresnel_dielectric(1 / n, cosine).reflectance == Approx(perpendicular / 2));
}

TEST_CASE("Beyond the critical angle everything is reflected", "[shading]") {
    const double n = 1.5, critical = std::sqrt(1 - 1 / (n * n));
    CHECK(fresnel_dielectric(n, critical * 0.999).total);
    CHECK(fresnel_dielectric(n, critical * 0.999).reflectance == 1);
    CHECK_FALSE(fresnel_dielectric(n, critical * 1.001).total);
    CHECK(fresnel_dielectric(1 / n, 0.0).reflectance == Approx(1));
}

TEST_CASE("Refracted directions are unit vectors that obey Snell's law", "[shading]") {
    const Vec3 normal(0, 0, 1);
    for (double angle = 0; angle < 1.5; angle += 0.1) {
        const Vec3 direction(std::sin(angle), 0, -std::cos(angle));
        const double eta = 1 / 1.33;
        const FresnelTerms fresnel = fresnel_dielectric(eta, std::cos(angle));
        const Vec3 r = refract(direction, normal, eta, std::cos(angle), fresnel.cos_refracted);
        CHECK(r.length() == Approx(1));
        CHECK(r.x == Approx(std::sin(angle) / 1.33).margin(1e-15));
        CHECK(r.z < 0);
    }
}
