#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/image/lazy_image.h"
#include "core/intersect/ray.h"
#include "core/numerics/vec_columns.h"
#include "core/scene/environment.h"

namespace etalon {

/// Radiance of rays that miss the scene. An image of a skybox is read when a ray first meets its
/// face.
class EnvironmentMap {
  public:
    /// `values`: what the background is and the radiance is to be, light (`linear`) or display
    /// values; images of the other kind are converted. If an image of the skybox is missing or its
    /// header is invalid, the background colour replaces the skybox; `problems` gets the reasons.
    EnvironmentMap(const Environment& environment, Encoding values,
                   std::vector<std::string>& problems);

    Color radiance(const Vec3& direction) const;

    /// Sets the colours of the rays that have not hit anything; others too, where that is less
    /// work.
    void set_radiance(const Vec3Span& directions, std::span<const Hit> hits,
                      std::span<Color> colors) const;

    /// Returns why faces met so far have the background's colour: their files are damaged after the
    /// header.
    std::vector<std::string> late_problems() const;

  private:
    const Environment& environment_;
    Encoding values_;
    std::array<LazyImage, 6> faces_;
    bool has_skybox_ = false;
};

}  // namespace etalon
