#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/light/spherical_image.h"
#include "core/scene/environment.h"
#include "core/shading/environment_map.h"

namespace etalon {

/// The light of a skybox.
class SkyboxLight {
  public:
    /// Its background is light. For `problems` see EnvironmentMap. All faces are read.
    SkyboxLight(const Environment& skybox, std::vector<std::string>& problems);

    Color radiance(const Vec3& direction) const { return map_.radiance(direction); }

    /// Returns an image of it whose texels are means over parts of their cells.
    SphericalImage overview(int width, int height) const;

  private:
    EnvironmentMap map_;
};

}  // namespace etalon
