#include "core/diffusion/tabulated_profile.h"

#include <numbers>

#include "core/numerics/catmull_rom.h"

namespace etalon {

TabulatedProfile::TabulatedProfile(const DiffusionTable& table, const Color& absorption,
                                   const Color& scattering)
    : extinction_(absorption + scattering) {
    for (int c = 0; c < 3; ++c) {
        rows_[c] = table.at(extinction_[c] > 0 ? scattering[c] / extinction_[c] : 0);
    }
}

float TabulatedProfile::out_of(int channel, float free_paths) const {
    const auto weights = spline_weights(DiffusionTable::distances(), free_paths);
    if (!weights) return 0;
    const DiffusionTable::Row& values = rows_[channel].values;
    const float sum = weights->sum([&](std::size_t k) { return values[k]; });
    return std::max(0.0F,
                    free_paths > 0 ? sum / (2 * std::numbers::pi_v<float> * free_paths) : sum);
}

float TabulatedProfile::value(int channel, float distance) const {
    const float extinction = extinction_[channel];
    return out_of(channel, distance * extinction) * extinction * extinction;
}

float TabulatedProfile::density(int channel, float distance) const {
    const float albedo = rows_[channel].albedo();
    return albedo > 0 ? value(channel, distance) / albedo : 0;
}

float TabulatedProfile::sample(int channel, double u) const {
    const DiffusionTable::Rows& rows = rows_[channel];
    if (!(rows.albedo() > 0)) return -1;
    const SplineSample chosen = sample_spline(
        DiffusionTable::distances(), [&](std::size_t k) -> double { return rows.values[k]; },
        [&](std::size_t k) -> double { return rows.sums[k]; }, u);
    return static_cast<float>(chosen.x) / extinction_[channel];
}

}  // namespace etalon
