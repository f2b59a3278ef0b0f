#include "core/bsdf/fourier.h"

#include "core/numerics/luminance.h"

#include "tests/catch.h"
#include "tests/fourier_tables.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("A table has the values that it was made from", "[bsdf]") {
    FourierTable table = table_of(cosines_of_table(20), 20, glossy_both_sides);
    for (const double eta : {1.0, 1.5}) {
        table.eta = static_cast<float>(eta);
        const FourierScattering lobe(table);
        for (const double o : {0.75, 0.3, -0.6}) {
            for (const double i : {0.75, 0.4, -0.2, -0.6}) {
                for (const double phi : {0.0, 0.7, 2.5, 4.0}) {
                    const double sine = std::sqrt(1 - i * i);
                    const Vec3 wo(std::sqrt(1 - o * o), 0, o);
                    const Vec3 wi(sine * std::cos(phi), sine * std::sin(phi), i);
                    // Where light passes, radiance is spread over other angles.
                    const double spread = o * i > 0 ? 1 : o > 0 ? 1 / (eta * eta) : eta * eta;
                    const Color expected = glossy_both_sides(wo, wi) * static_cast<float>(spread);
                    const Color f = lobe.evaluate(Vec3f(wo), Vec3f(wi)).f;
                    CAPTURE(o, i, phi, eta);
                    // Sines, and so all terms that depend on phi, are not splines near the normal,
                    // which is left out.
                    for (int c = 0; c < 3; ++c) CHECK(f[c] == Approx(expected[c]).epsilon(0.05));
                }
            }
        }
    }
}

TEST_CASE("A table's albedo is the light that it scatters", "[bsdf]") {
    const FourierTable table = table_of(cosines_of_table(20), 20, glossy_both_sides);
    const FourierScattering lobe(table);
    FourierScattering dimmed = lobe;
    dimmed.scale(Color(0.5F));
    for (const float cos : {1.0F, 0.5F, -0.1F}) {
        const Vec3f wo(std::sqrt(1 - cos * cos), 0, cos);
        double sum = 0;
        constexpr int steps = 200;
        for (int a = 0; a < steps; ++a) {
            for (int b = 0; b < steps; ++b) {
                const double z = 2 * (a + 0.5) / steps - 1, phi = 2 * std::numbers::pi * b / steps;
                const double sine = std::sqrt(1 - z * z);
                const Vec3 wi(sine * std::cos(phi), sine * std::sin(phi), z);
                sum += luminance(lobe.evaluate(wo, Vec3f(wi)).f) * std::abs(z);
            }
        }
        sum *= 4 * std::numbers::pi / (steps * steps);
        CHECK(lobe.albedo(wo).y == Approx(sum).epsilon(0.02));
        CHECK(dimmed.albedo(wo).y == Approx(lobe.albedo(wo).y / 2));
    }
}

TEST_CASE("A table without light scatters none", "[bsdf]") {
    const FourierTable black =
        table_of(cosines_of_table(4), 4, [](const Vec3&, const Vec3&) { return Color(0.0F); });
    const FourierScattering lobe(black);
    const Vec3f wo(0.6F, 0, 0.8F);
    CHECK_FALSE(lobe.sample(wo, {0.3, 0.4}));
    CHECK(lobe.evaluate(wo, wo).f == Color(0.0F));
    CHECK(lobe.evaluate(wo, wo).pdf == 0);
    CHECK(lobe.albedo(wo) == Color(0.0F));
    // A table with steep directions only has no values for others.
    const FourierTable steep =
        table_of({0.5F, 0.7F, 1}, 4, [](const Vec3&, const Vec3&) { return Color(0.2F); });
    CHECK_FALSE(FourierScattering(steep).sample(Vec3f(1, 0, 0), {0.3, 0.4}));
}
