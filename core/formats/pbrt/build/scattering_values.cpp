#include "core/formats/pbrt/build/scattering_values.h"

#include "core/formats/nearest_name.h"

namespace etalon::pbrt {
namespace {

/// Largest mean cosine: scattering straight ahead has no density.
constexpr float largest_cosine = 0.9999F;

}  // namespace

float mean_cosine(SceneBuilder& b, const Plugin& medium) {
    const float g = medium.parameters.number("g");
    const float nearest = std::clamp(g, -largest_cosine, largest_cosine);
    if (nearest != g) {
        b.warn(medium.where, "medium", "'g' {}: expected a number between -1 and 1; taken as {}", g,
               nearest);
    }
    return nearest;
}

const ScatteringPreset* preset_of(SceneBuilder& b, const Plugin& plugin,
                                  std::string_view parameter) {
    const std::string name(plugin.parameters.string(parameter));
    if (name.empty()) return nullptr;
    const ScatteringPreset* const found = find_scattering_preset(name);
    if (!found) {
        b.warn(plugin.where, "preset", "unknown preset '{}'; it has the defaults{}", name,
               did_you_mean(name, scattering_preset_names()));
    }
    return found;
}

}  // namespace etalon::pbrt
