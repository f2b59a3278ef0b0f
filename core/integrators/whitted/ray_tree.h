#pragma once

#include <memory>
#include <vector>

#include "core/integrators/whitted/padded_color.h"
#include "core/integrators/whitted/secondary_rays.h"
#include "core/sampling/dimensions.h"
#include "core/sampling/sample_source.h"
#include "core/shading/shadow_rays.h"

namespace etalon {

/// Rays of the same depth, traced together, and the path of each.
struct RayBatch {
    RayStream rays;
    std::span<const RayPath> paths;
    std::span<const SampleSource> sources;  ///< one for each camera ray
};

/// Buffers for the trees of rays of many samples, which are traced together, level by level: the
/// camera rays are the first level. Reused from batch to batch.
class RayTree {
  public:
    /// The data of one batch of rays. A level has one batch at a time.
    struct Level {
        std::vector<Hit> hits;
        SeenSurfaces surfaces;
        std::vector<PaddedColor> colors;  ///< radiance that the surfaces send back along the rays
        SecondaryRays secondary;
        std::vector<ShutterTime> secondary_times;
        std::vector<Color> incoming;  ///< radiance that the secondary rays bring back

        VertexNames vertices;        ///< one for each surface, for its random choices
        SeededPoints light_samples;  ///< for a point of the light for each surface
        LightPoints light_points;    ///< that point
        ShadowRays shadow;
        std::vector<ShutterTime> shadow_times;
        PaddedColumn<float> highlights;  ///< at the origin of each shadow ray
        std::vector<PaddedColor>
            reflected;                 ///< light reflected from a white light, for each surface
        std::vector<PaddedColor> lit;  ///< light reflected from all lights, for each surface
    };

    /// Returns the level of a depth, 1 for camera rays. References to levels stay valid.
    Level& level(int depth) {
        while (levels_.size() < static_cast<std::size_t>(depth)) {
            levels_.push_back(std::make_unique<Level>());
        }
        return *levels_[depth - 1];
    }

    /// Returns the paths of `count` camera rays.
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
