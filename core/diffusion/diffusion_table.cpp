#include "core/diffusion/diffusion_table.h"

#include <cmath>
#include <numbers>

#include "core/diffusion/beam_diffusion.h"
#include "core/numerics/catmull_rom.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

DiffusionTable::Row make_distances() {
    DiffusionTable::Row row{};
    row[1] = 2.5e-3F;
    for (std::size_t k = 2; k < row.size(); ++k) row[k] = 1.2F * row[k - 1];
    return row;
}

/// Albedos, the closer together the nearer they are to 1, where little changes much.
float albedo_number(std::size_t i) {
    const float part = static_cast<float>(i) / (DiffusionTable::albedos - 1);
    return (1 - std::exp(-8 * part)) / (1 - std::exp(-8.0F));
}

DiffusionTable::Rows rows_of(const HalfSpace& medium) {
    DiffusionTable::Rows rows{};
    const DiffusionTable::Row& distances = DiffusionTable::distances();
    for (std::size_t k = 0; k < DiffusionTable::radii; ++k) {
        const float r = distances[k];
        const float out = single_scattering(medium, r) + multiple_scattering(medium, r);
        const float value = 2 * std::numbers::pi_v<float> * r * out;
        rows.values[k] = std::isfinite(value) ? value : 0;
    }
    integrate_spline(distances, rows.values, rows.sums);
    return rows;
}

}  // namespace

const DiffusionTable::Row& DiffusionTable::distances() {
    static const Row row = make_distances();
    return row;
}

DiffusionTable::DiffusionTable(float g, float eta) : rows_(albedos) {
    parallel_for(albedos, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            albedos_[i] = albedo_number(i);
            rows_[i] = rows_of({albedos_[i], g, eta});
            effective_[i] = rows_[i].albedo();
        }
    });
}

DiffusionTable::Rows DiffusionTable::at(float albedo) const {
    Rows result{};
    const auto weights = spline_weights(albedos_, albedo);
    if (!weights) return result;
    for (std::size_t w = 0; w < 4; ++w) {
        const float weight = weights->weights[w];
        if (weight == 0) continue;
        const Rows& rows = rows_[weights->first + w - 1];
        for (std::size_t k = 0; k < radii; ++k) {
            result.values[k] += weight * rows.values[k];
            result.sums[k] += weight * rows.sums[k];
        }
    }
    return result;
}

float DiffusionTable::albedo_of(float effective_albedo) const {
    return invert_spline(albedos_, effective_, effective_albedo);
}

}  // namespace etalon
