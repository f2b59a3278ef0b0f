// What media and materials say alike of light that is scattered within them.
#pragma once

#include "core/formats/pbrt/build/scattering_presets.h"
#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {

/// The preset that a parameter names; null, and a warning unless it is not given, if there is none.
const ScatteringPreset* preset_of(SceneBuilder& b, const Plugin& plugin,
                                  std::string_view parameter);

inline Color color_of(const std::array<float, 3>& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

/// The parameter "g"; the nearest cosine for which there is scattering, and a warning, where it is
/// none.
float mean_cosine(SceneBuilder& b, const Plugin& plugin);

}  // namespace etalon::pbrt
