// Every integrator there is, by name.
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

/// A way to compute images.
struct IntegratorType {
    std::string_view name;
    std::string_view summary;
    /// The render settings that only some integrators obey, and this one does, as the command line
    /// spells them. Others are refused with it.
    std::span<const std::string_view> options;
    /// Scene, one made ready by prepare_scene(), and intersector must outlive the integrator.
    /// `problems` gets the reasons why parts of the scene are replaced: a skybox that cannot be
    /// read by the background's colour.
    std::unique_ptr<Integrator> (*make)(const Scene& scene, const BatchIntersector& intersector,
                                        const RenderSettings& settings,
                                        std::vector<std::string>& problems);

    bool takes_whitted, takes_physical;  ///< looks that it renders as they are

    bool obeys(std::string_view option) const;

    /// Whether it can render the scene, as it is or with a physical look.
    bool renders(const Scene& scene) const { return takes_physical || !scene.is_physical(); }

    /// Gives the scene, one that it renders(), a physical look where the integrator needs one, and
    /// settings to go with it: see make_physical().
    void prepare_scene(Scene& scene, RenderSettings& settings) const;
};

/// Returns all integrators, in the order of help texts. CONTRIBUTING.md lists what a new one takes.
std::span<const IntegratorType> all_integrators();

/// Returns the integrator of that name, or nullptr if there is none.
const IntegratorType* find_integrator(std::string_view name);

/// Names of all integrators: "whitted", ...
std::vector<std::string> integrator_names();

/// Names of those that render the scene.
std::vector<std::string> integrators_for(const Scene& scene);

/// Names of those that obey an option, as the command line spells it.
std::vector<std::string> integrators_with(std::string_view option);

}  // namespace etalon
