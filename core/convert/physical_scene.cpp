#include "core/convert/physical_scene.h"

#include <algorithm>

#include "core/convert/physical_lights.h"
#include "core/convert/physical_material.h"

namespace etalon {
namespace {

/// Binds every material, under its number.
void add_bindings(const std::vector<Material>& materials, const LightValues& light,
                  PhysicalLook& to) {
    for (const Material& material : materials) {
        SurfaceBinding binding;
        binding.material = add_physical(material, light, to.materials);
        to.bindings.push_back(binding);
    }
}

}  // namespace

void make_physical(Scene& scene, RenderSettings& settings) {
    if (scene.is_physical()) return;
    const LightValues light(settings.display_colors);
    const WhittedLook& from = scene.whitted();
    PhysicalLook to;
    add_bindings(from.materials, light, to);
    add_physical_lights(from, scene.camera, light, scene.geometry, to);
    add_physical_environment(from.environment, light, to);
    scene.look = std::move(to);

    settings.integrator = "path";
    settings.display_colors = false;
    settings.whitted = {};
    settings.max_depth = std::max(settings.max_depth, physical_depth);
    if (settings.samples_per_pixel == 0) settings.samples_per_pixel = physical_samples;
}

}  // namespace etalon
