#include <numbers>

#include "core/diffusion/subsurface.h"
#include "tests/catch.h"
#include "tests/chi_square.h"
#include "tests/diffusion/profiles.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Integral of f over a plane; f may be infinite at the origin and has about this extent.
template <class Function>
double integral_over_plane(const Function& f, double reach) {
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps, r = 30 * reach * t * t * t;
        const double dr = 90 * reach * t * t / steps;
        sum += 2 * std::numbers::pi * r * dr * f(static_cast<float>(r));
    }
    return sum;
}

}  // namespace

TEST_CASE("A tabulated profile has pbrt-v3's values", "[diffusion]") {
    const TabulatedProfile p = tabulated();
    const float value[] = {0.2045176F, 0.1003663F, 0.02241803F};
    const float density[] = {0.4570518F, 0.5676047F, 0.4858985F};
    const float median[] = {0.5543141F, 0.3148716F, 0.112143F};
    const float far[] = {5.455028F, 3.134167F, 1.596401F};
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(p.value(c, 0.3F) == Approx(value[c]).epsilon(2e-3));
        CHECK(p.density(c, 0.3F) == Approx(density[c]).epsilon(2e-3));
        CHECK(p.sample(c, 0.5) == Approx(median[c]).epsilon(2e-3));
        CHECK(p.sample(c, 0.999) == Approx(far[c]).epsilon(1e-2));
    }
}

TEST_CASE("Light that goes in comes out by the part that is the albedo", "[diffusion]") {
    for (const auto& [name, profile, albedo] : profiles()) {
        for (int c = 0; c < 3; ++c) {
            INFO(name << ", channel " << c);
            std::visit(
                [&, a = albedo](const auto& p) {
                    const double reach = p.sample(c, 0.99);
                    CHECK(integral_over_plane([&](float r) { return p.density(c, r); }, reach) ==
                          Approx(1).epsilon(2e-3));
                    CHECK(integral_over_plane([&](float r) { return p.value(c, r); }, reach) ==
                          Approx(a[c]).epsilon(2e-3));
                },
                profile);
        }
    }
}

TEST_CASE("Distances are drawn with the density that is said of them", "[diffusion]") {
    constexpr int bins = 20, samples = 100000;
    for (const auto& [name, profile, albedo] : profiles()) {
        for (int c = 0; c < 3; ++c) {
            INFO(name << ", channel " << c);
            std::visit(
                [&](const auto& p) {
                    // Bins of equal probability.
                    const double reach = p.sample(c, 0.999);
                    double chi = 0, edge = 0;
                    std::vector<double> edges;
                    double sum = 0;
                    constexpr int steps = 400000;
                    for (int i = 0; i < steps; ++i) {
                        const double t = (i + 0.5) / steps, r = 4 * reach * t * t * t;
                        const double dr = 12 * reach * t * t / steps;
                        sum += 2 * std::numbers::pi * r * dr * p.density(c, static_cast<float>(r));
                        edge = r;
                        if (sum >= (static_cast<double>(edges.size()) + 1) / bins)
                            edges.push_back(edge);
                    }
                    edges.resize(bins - 1, edge);
                    std::vector<int> counts(bins);
                    Random random(7);
                    for (int i = 0; i < samples; ++i) {
                        const double r = p.sample(c, random.uniform());
                        ++counts[std::ranges::upper_bound(edges, r) - edges.begin()];
                    }
                    constexpr double expected = double(samples) / bins;
                    for (const int n : counts) chi += (n - expected) * (n - expected) / expected;
                    CHECK(chi < 55);  // of 19 degrees of freedom: 1 in 4e4
                },
                profile);
        }
    }
}

TEST_CASE("A channel in which nothing is scattered chooses no distance", "[diffusion]") {
    const DiffusionTable table(0, 1.3F);
    const TabulatedProfile clear(table, {0, 1, 2}, {0, 0, 1});
    CHECK(clear.sample(0, 0.5) < 0);
    CHECK(clear.sample(1, 0.5) < 0);
    CHECK(clear.sample(2, 0.5) > 0);
    const NormalizedProfile near(Color(0.5F), {0, 1, 1});
    CHECK(near.sample(0, 0.5) < 0);
    for (const SpreadProfile& p : {SpreadProfile(clear), SpreadProfile(near)}) {
        const auto [value, density] = std::visit(
            [](const auto& kind) { return std::pair(kind.value(0, 1), kind.density(0, 1)); }, p);
        CHECK(value == 0);
        CHECK(density == 0);
    }
}
