#include "core/integrators/integrators.h"

#include <algorithm>

#include "core/convert/physical_scene.h"
#include "core/integrators/ao/ambient_occlusion.h"
#include "core/integrators/path/path.h"
#include "core/integrators/whitted/whitted.h"

namespace etalon {
namespace {

template <class Type>
std::unique_ptr<Integrator> make(const Scene& scene, const BatchIntersector& intersector,
                                 const RenderSettings& settings,
                                 std::vector<std::string>& problems) {
    return std::make_unique<Type>(scene, intersector, settings, problems);
}

constexpr std::string_view whitted_options[] = {"--max-depth", "--spd"};
constexpr std::string_view path_options[] = {"--max-depth"};
constexpr std::string_view ao_options[] = {"--max-distance"};

constexpr IntegratorType integrators[] = {
    {"whitted", "lights, mirrors and glass by the rules of the scene's format", whitted_options,
     make<Whitted>, true, false, true},
    {"path", "light over any number of bounces, by physical rules", path_options, make<PathTracer>,
     false, true, false},
    {"volpath", "path through fog, smoke and other media of a PBRT scene", path_options,
     make<VolumePathTracer>, false, true, false},
    {"ao", "ambient occlusion: the share of directions in which nothing is near", ao_options,
     make<AmbientOcclusion>, true, true, false},
};

/// Returns the names of the integrators for which `test` holds.
template <class Test>
std::vector<std::string> names_where(const Test& test) {
    std::vector<std::string> names;
    for (const IntegratorType& type : integrators) {
        if (test(type)) names.emplace_back(type.name);
    }
    return names;
}

}  // namespace

void IntegratorType::prepare_scene(Scene& scene, RenderSettings& settings) const {
    if (!takes_whitted) make_physical(scene, settings);
    if (!has_display_colors) settings.display_colors = false;
}

bool IntegratorType::obeys(std::string_view option) const {
    return std::ranges::find(options, option) != options.end();
}

std::span<const IntegratorType> all_integrators() {
    return integrators;
}

const IntegratorType* find_integrator(std::string_view name) {
    const auto found = std::ranges::find(integrators, name, &IntegratorType::name);
    return found != std::end(integrators) ? found : nullptr;
}

std::vector<std::string> integrator_names() {
    return names_where([](const IntegratorType&) { return true; });
}

std::vector<std::string> integrators_for(const Scene& scene) {
    return names_where([&](const IntegratorType& type) { return type.renders(scene); });
}

std::vector<std::string> integrators_with(std::string_view option) {
    return names_where([&](const IntegratorType& type) { return type.obeys(option); });
}

}  // namespace etalon
