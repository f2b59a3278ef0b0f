#pragma once

#include <atomic>
#include <functional>

#include "app/common/backends.h"
#include "bench/convergence/curve.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon::convergence {

/// Returns the names of the sampling methods: "random", "sobol" and "adaptive".
const std::vector<std::string>& sampler_names();

struct ConvergenceConfig {
    std::vector<std::string> samplers = sampler_names();
    std::vector<std::string> backends{default_backend};
    int samples = 64;  ///< per pixel, at the end of each curve
    int seeds = 3;
    /// CPU seconds of starting the process and reading the scene, which are added to each curve's
    /// preparation.
    double reading_seconds = 0;
};

/// Stop flag and callbacks of a task.
struct RunProgress {
    const std::atomic<bool>& stop;         ///< if set, stop soon
    std::function<void(double)> progress;  ///< called with the fraction done, from any thread
    std::function<void(const Curve&)> after_curve{};  ///< called with each curve, if there is one
};

/// The image to which all curves converge: Sobol' points of a seed that no curve has, and so many
/// times the samples of a curve's end that hardly any of the difference is its own.
struct ReferenceImage {
    std::vector<Color> pixels;
    std::string description;
};

inline constexpr int reference_times = 32;

ReferenceImage render_reference(const Scene& scene, const RenderSettings& settings,
                                const ConvergenceConfig& config, const RunProgress& run);

/// Returns the curves, with the integrator of the settings, of all samplers with the first backend,
/// and of the last sampler with the others. A stop leaves the last one with fewer seeds, and out
/// if it has none.
std::vector<Curve> measure(const Scene& scene, const RenderSettings& settings,
                           const ReferenceImage& reference, const ConvergenceConfig& config,
                           const RunProgress& run);

}  // namespace etalon::convergence
