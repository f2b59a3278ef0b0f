// Scattering parameters that media and materials share.
#pragma once

#include "core/formats/pbrt/build/scattering_presets.h"
#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {

/// Returns the preset that a parameter names. If there is none, returns null, and warns if the
/// parameter is given.
const ScatteringPreset* preset_of(SceneBuilder& b, const Plugin& plugin,
                                  std::string_view parameter);

inline Color color_of(const std::array<float, 3>& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

/// Returns the parameter "g". If it is not a valid mean cosine, warns and returns the nearest one
/// for which there is scattering.
float mean_cosine(SceneBuilder& b, const Plugin& plugin);

}  // namespace etalon::pbrt
