// Names of integrators on the command line.
#pragma once

#include "core/integrators/integrators.h"

namespace etalon {

/// Name on the command line for the integrator of the scene's own settings.
inline constexpr std::string_view scene_integrator = "auto";

/// Returns scene_integrator and the names of all integrators.
inline std::vector<std::string> integrator_choices() {
    std::vector<std::string> choices = integrator_names();
    choices.insert(choices.begin(), std::string(scene_integrator));
    return choices;
}

/// Overrides the scene's own integrator, also where that sees direct light only, by one of the
/// choices.
inline void choose_integrator(std::string_view choice, RenderSettings& settings) {
    if (choice == scene_integrator) return;
    settings.integrator = choice;
    settings.direct_lighting = settings.sample_all_lights = false;
}

/// Prepares a scene for one of the choices, if that can render it.
inline void prepare_scene(std::string_view choice, Scene& scene, RenderSettings& settings) {
    if (choice == scene_integrator) return;
    const IntegratorType& type = *find_integrator(choice);
    if (type.renders(scene)) type.prepare_scene(scene, settings);
}

}  // namespace etalon
