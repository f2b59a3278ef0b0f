// Measured coefficients of subsurface scattering, by the names that PBRT's scenes use.
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace etalon::pbrt {

/// Coefficients per millimetre for red, green and blue. That of scattering is the reduced one, as
/// if scattering were isotropic.
struct ScatteringPreset {
    std::string_view name;
    std::array<float, 3> absorption, scattering;
};

/// Returns the preset of that name; null if there is none.
const ScatteringPreset* find_scattering_preset(std::string_view name);

std::vector<std::string_view> scattering_preset_names();

}  // namespace etalon::pbrt
