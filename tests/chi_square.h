// Pearson's chi-square test of whether sampled directions have a given density, over a grid on the
// sphere, as Mitsuba and PBRT test their sampling.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "core/numerics/random.h"

namespace etalon::test {

using SphereDensity = std::function<double(const Vec3&)>;
using SphereSampler = std::function<std::optional<Vec3>(Random&)>;

/// Part of the sphere: a range of the angle to z and one of the angle about z.
struct SpherePatch {
    double theta, theta_end, phi, phi_end;
};

inline Vec3 direction_at(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Returns the integral of a density over a patch by the Gauss-Legendre rule of 4 x 4 points.
inline double integral_by_rule(const SphereDensity& density, const SpherePatch& patch) {
    constexpr double nodes[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                0.8611363115940526};
    constexpr double weights[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                  0.3478548451374538};
    const double half_theta = (patch.theta_end - patch.theta) / 2;
    const double half_phi = (patch.phi_end - patch.phi) / 2;
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const double theta = patch.theta + half_theta * (1 + nodes[i]);
        for (int k = 0; k < 4; ++k) {
            const double phi = patch.phi + half_phi * (1 + nodes[k]);
            sum += weights[i] * weights[k] * std::sin(theta) * density(direction_at(theta, phi));
        }
    }
    return sum * half_theta * half_phi;
}

/// Returns the integral over a patch, which is quartered twice, so that no narrow peak is missed,
/// and then until that changes it by no more than 1e-6.
inline double integral(const SphereDensity& density, const SpherePatch& patch, int level = 0) {
    constexpr int least = 2, most = 6;
    const double theta = (patch.theta + patch.theta_end) / 2;
    const double phi = (patch.phi + patch.phi_end) / 2;
    const SpherePatch quarters[] = {{patch.theta, theta, patch.phi, phi},
                                    {theta, patch.theta_end, patch.phi, phi},
                                    {patch.theta, theta, phi, patch.phi_end},
                                    {theta, patch.theta_end, phi, patch.phi_end}};
    double sum = 0;
    if (level >= least) {
        for (const SpherePatch& quarter : quarters) sum += integral_by_rule(density, quarter);
        if (level == most || std::abs(sum - integral_by_rule(density, patch)) < 1e-6) return sum;
        sum = 0;
    }
    for (const SpherePatch& quarter : quarters) sum += integral(density, quarter, level + 1);
    return sum;
}

/// Returns the sphere divided into `bands` x `sectors` patches; for an even number of bands the
/// equator is a border.
inline std::vector<SpherePatch> sphere_patches(int bands, int sectors) {
    constexpr double pi = std::numbers::pi;
    std::vector<SpherePatch> patches;
    for (int band = 0; band < bands; ++band) {
        for (int sector = 0; sector < sectors; ++sector) {
            patches.push_back({pi * band / bands, pi * (band + 1) / bands,
                               2 * pi * sector / sectors, 2 * pi * (sector + 1) / sectors});
        }
    }
    return patches;
}

inline double integral_over_sphere(const SphereDensity& density) {
    double sum = 0;
    for (const SpherePatch& patch : sphere_patches(8, 16)) sum += integral(density, patch);
    return sum;
}

/// Returns the probability that chi-square is no less than `statistic` (Wilson and Hilferty 1931,
/// accurate enough for ten degrees of freedom and more).
inline double chi_square_tail(double statistic, double degrees) {
    const double spread = 2 / (9 * degrees);
    const double z = (std::cbrt(statistic / degrees) - (1 - spread)) / std::sqrt(spread);
    return std::erfc(z / std::numbers::sqrt2) / 2;
}

/// Returns the probability for observed and expected `numbers`, by cell; cells of fewer than five
/// are pooled.
inline double chi_square_probability(const std::vector<double>& numbers,
                                     const std::vector<double>& expected) {
    double statistic = 0, pooled = 0, pooled_expected = 0;
    int cells = 0;
    const auto count = [&](double number, double expectation) {
        statistic += (number - expectation) * (number - expectation) / expectation;
        ++cells;
    };
    for (std::size_t k = 0; k < expected.size(); ++k) {
        if (expected[k] >= 5) {
            count(numbers[k], expected[k]);
        } else {
            pooled += numbers[k];
            pooled_expected += expected[k];
        }
    }
    if (pooled_expected >= 5) {
        count(pooled, pooled_expected);
    } else if (pooled > 5 + 5 * std::sqrt(pooled_expected + 1)) {
        return 0;  // many where there should be almost none
    }
    return cells < 2 ? 1 : chi_square_tail(statistic, cells - 1);
}

/// Returns the probability that directions of this density deviate from it at least as much as the
/// sampler's do. A sampler that sometimes yields none has a density whose integral is
/// correspondingly below 1.
inline double chi_square_probability(const SphereSampler& sample, const SphereDensity& density,
                                     std::uint64_t seed, int draws = 100000) {
    constexpr int bands = 14, sectors = 28;
    std::vector<double> numbers(bands * sectors + 1), expected;
    Random random(seed);
    for (int k = 0; k < draws; ++k) {
        const std::optional<Vec3> drawn = sample(random);
        if (!drawn) {
            ++numbers.back();
            continue;
        }
        const double theta = std::acos(std::clamp(drawn->z, -1.0, 1.0));
        const double phi = std::atan2(drawn->y, drawn->x);
        const double turn = (phi < 0 ? phi + 2 * std::numbers::pi : phi) / (2 * std::numbers::pi);
        const int band = std::min(bands - 1, static_cast<int>(theta / std::numbers::pi * bands));
        ++numbers[band * sectors + std::min(sectors - 1, static_cast<int>(turn * sectors))];
    }
    double none = draws;
    for (const SpherePatch& patch : sphere_patches(bands, sectors)) {
        expected.push_back(draws * integral(density, patch));
        none -= expected.back();
    }
    expected.push_back(std::max(none, 0.0));
    return chi_square_probability(numbers, expected);
}

/// Returns the significance level of each of `tests` independent tests for which the chance of any
/// false alarm is `total` (Sidak).
inline double sidak(double total, std::size_t tests) {
    return 1 - std::pow(1 - total, 1.0 / static_cast<double>(tests));
}

}  // namespace etalon::test
