#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/scene/environment.h"

namespace etalon {

/// Environment ready for lookups by rays that leave the scene: a skybox's images are read here.
class EnvironmentMap {
  public:
    /// A skybox with an image that cannot be read is replaced by the background; `problems` gets
    /// the reasons.
    EnvironmentMap(const Environment& environment, std::vector<std::string>& problems);

    Color radiance(const Vec3& direction) const;

  private:
    const Environment& environment_;
    std::array<Image, 6> faces_;
    bool has_skybox_ = false;
};

}  // namespace etalon
