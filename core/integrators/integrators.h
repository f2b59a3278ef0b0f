// All integrators, by name.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/intersect/batch_intersector.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

/// Description of an integrator.
struct IntegratorType {
    std::string_view name;
    std::string_view summary;
    /// The render settings that this integrator uses and others may not, as spelt on the command
    /// line. An integrator that does not list a setting refuses it.
    std::span<const std::string_view> options;
    /// Makes the integrator. Scene, after prepare_scene(), and intersector must outlive it.
    /// `problems` gets the reasons why parts of the scene are replaced: an unreadable skybox by the
    /// background's colour.
    std::unique_ptr<Integrator> (*make)(const Scene& scene, const BatchIntersector& intersector,
                                        const RenderSettings& settings,
                                        std::vector<std::string>& problems);

    bool takes_whitted, takes_physical;  ///< looks that it renders without conversion
    /// Whether it computes the colours of a Whitted look, which may be display values.
    bool has_display_colors;

    bool obeys(std::string_view option) const;

    /// Returns whether it can render the scene, as it is or with a physical look.
    bool renders(const Scene& scene) const { return takes_physical || !scene.is_physical(); }

    /// Gives the scene, for which renders() must hold, a physical look if the integrator needs one,
    /// and suitable settings: see make_physical().
    void prepare_scene(Scene& scene, RenderSettings& settings) const;
};

/// Returns all integrators, in the order of help texts. CONTRIBUTING.md lists the steps to add one.
std::span<const IntegratorType> all_integrators();

/// Returns the integrator of that name, or nullptr if there is none.
const IntegratorType* find_integrator(std::string_view name);

/// Returns the names of all integrators: "whitted", ...
std::vector<std::string> integrator_names();

/// Returns the names of those that can render the scene.
std::vector<std::string> integrators_for(const Scene& scene);

/// Returns the names of those that use an option, as spelt on the command line.
std::vector<std::string> integrators_with(std::string_view option);

}  // namespace etalon
