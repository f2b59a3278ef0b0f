#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/render/arguments.h"
#include "app/render/scene_source.h"
#include "core/integrators/integrator.h"
#include "core/intersect/intersector.h"
#include "core/intersect/packet_intersector.h"
#include "core/shading/physical_shading.h"

namespace etalon {

/// A scene, and all that is made of it before the first ray: its settings, the backend's structure
/// and the integrator. load() comes first, then build().
class PreparedScene {
  public:
    /// The arguments must outlive this.
    explicit PreparedScene(const RenderArguments& arguments) : a_(arguments) {}

    /// Reads the scene and determines the settings. Returns the exit status, and prints why if it
    /// is not 0.
    int load(SceneSource& source);

    /// Builds the backend and makes the integrator. Returns false, and prints why, if images of the
    /// scene are unusable and have no substitute.
    bool build();

    const Scene& scene() const { return scene_; }
    const RenderSettings& settings() const { return settings_; }
    const std::vector<std::string>& files() const { return files_; }
    const Intersector& intersector() const { return *intersector_; }
    const Integrator& integrator() const { return *integrator_; }

    /// Returns the evaluated materials of a physical look, for AOVs; null if none needs them.
    const PhysicalShading* shading() const;

  private:
    const RenderArguments& a_;
    Scene scene_;
    RenderSettings settings_;
    std::vector<std::string> files_;
    std::unique_ptr<Intersector> intersector_;
    std::optional<PacketIntersector> packets_;
    std::unique_ptr<Integrator> integrator_;
    std::optional<PhysicalShading> shading_;  ///< if the integrator has none
};

}  // namespace etalon
