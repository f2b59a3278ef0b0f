#pragma once

#include "core/diffusion/diffusion_table.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Distribution of light below the surface of a medium with different coefficients for each
/// channel.
class TabulatedProfile {
  public:
    /// `absorption`, `scattering`: per unit of length, not below 0. No light leaves of a channel in
    /// which both are 0.
    TabulatedProfile(const DiffusionTable& table, const Color& absorption, const Color& scattering);

    float value(int channel, float distance) const;
    float density(int channel, float distance) const;
    float sample(int channel, double u) const;

  private:
    /// Evaluates the row's spline over 2 pi r, in free paths.
    float out_of(int channel, float free_paths) const;

    Color extinction_;
    std::array<DiffusionTable::Rows, 3> rows_;
};

}  // namespace etalon
