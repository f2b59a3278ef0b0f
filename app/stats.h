#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/common/stopwatch.h"
#include "core/integrators/ray_counts.h"
#include "core/scene/scene.h"

namespace etalon {

/// Numbers of primitives by kind, including those of objects.
using PrimitiveCounts = std::array<std::uint64_t, shape_kinds>;

/// Contents of `render --stats`. The keys are stable.
struct RenderStats {
    std::string scene, format, backend, integrator, isa;
    bool direct_lighting = false;  ///< only direct light, also in mirrors and glass
    int threads = 0;
    int width = 0, height = 0;
    double samples_per_pixel = 0;  ///< mean number taken; 0: one ray through each centre
    std::uint64_t seed = 0;
    PrimitiveCounts primitives{};
    Duration parse, build, render, aovs, write;
    RayCounts rays;
    std::uint64_t resumed_rays = 0;  ///< of these, the ones before the resumed checkpoint
    std::optional<double> resumed_samples_per_pixel{};  ///< only if rendering was resumed
    int checkpoints = 0;                                ///< number written
    double checkpoint_seconds = 0;                      ///< wall time that they took
    std::uint64_t dropped_samples = 0;
    std::string stopped;  ///< "signal" or "time-limit"; empty if the image is complete
    std::optional<double> target_error, expected_error;  ///< relMSE: requested and estimated
    std::size_t scene_bytes = 0, accelerator_bytes = 0;
};

nlohmann::ordered_json to_json(const RenderStats& stats);

PrimitiveCounts primitive_counts(const Scene& scene);

/// Returns {"sphere": 3, ...}: the kinds that occur, in the order of ShapeArrays.
nlohmann::ordered_json to_json(const PrimitiveCounts& counts);

}  // namespace etalon
