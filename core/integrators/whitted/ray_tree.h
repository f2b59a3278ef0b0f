#pragma once

#include <memory>
#include <vector>

#include "core/integrators/whitted/padded_color.h"
#include "core/integrators/whitted/secondary_rays.h"
#include "core/sampling/dimensions.h"
#include "core/sampling/sample_source.h"
#include "core/shading/shadow_rays.h"

namespace etalon {

/// Rays of the same depth, followed together, and the path of each.
struct RayBatch {
    RayStream rays;
    std::span<const RayPath> paths;
    std::span<const SampleSource> sources;  ///< of the camera rays
};

/// Where trees of rays, one for each sample, are kept while they are followed, all together and
/// level by level: the camera rays are of the first. To be used again and again.
class RayTree {
  public:
    /// What is known of one batch. A level has one batch at a time.
    struct Level {
        std::vector<Hit> hits;
        SeenSurfaces surfaces;
        std::vector<Color> colors;  ///< that the surfaces send back along the rays
        SecondaryRays secondary;
        std::vector<ShutterTime> secondary_times;
        std::vector<Color> incoming;  ///< by these

        Vec3Buffer light_points;  ///< one for each surface
        ShadowRays shadow;
        std::vector<ShutterTime> shadow_times;
        std::vector<std::uint8_t> blocked;   ///< whether these rays are
        PaddedColumn<float> highlights;      ///< at the surfaces that these rays leave
        std::vector<PaddedColor> reflected;  ///< part of a white light that surfaces send back
        std::vector<PaddedColor> lit;        ///< what all lights give
    };

    /// The level of that depth, 1 for camera rays. Levels stay where they are.
    Level& level(int depth) {
        while (levels_.size() < static_cast<std::size_t>(depth)) {
            levels_.push_back(std::make_unique<Level>());
        }
        return *levels_[depth - 1];
    }

    /// The paths of so many camera rays.
    std::span<const RayPath> camera_paths(std::size_t count) {
        for (auto i = static_cast<std::uint32_t>(camera_paths_.size()); i < count; ++i) {
            camera_paths_.push_back({i, camera_ray_name, Color(0.0F)});
        }
        return std::span(camera_paths_).first(count);
    }

  private:
    std::vector<RayPath> camera_paths_;
    std::vector<std::unique_ptr<Level>> levels_;
};

}  // namespace etalon
