// From a scene to a film: tiles over threads, rounds of samples.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "core/intersect/intersector.h"
#include "core/render/deadline.h"
#include "core/render/film.h"
#include "core/render/ray_counts.h"
#include "core/sampling/sample_source.h"
#include "core/scene/scene.h"
#include "core/shading/environment_map.h"

namespace etalon {

/// A picture as it is after a round, or after what a stop left of it.
struct RenderedRound {
    const Film& film;
    double expected_error;  ///< relMSE; 0 unless an error was asked for
};

struct RenderOptions {
    int samples_per_pixel = 0;  ///< 0: the camera's PixelRays
    int max_depth = 5;          ///< rays in a row, the eye's included
    std::uint32_t seed = 0;
    Sampler sampler = Sampler::sobol;
    Imath::Box2i window;    ///< pixels to render, inclusive on both ends
    double error = 0;       ///< above 0: the relMSE at which the picture is good enough; samples go
                            ///< where they help, samples_per_pixel at most
    bool variance = false;  ///< keep what the film's variances need
    Deadline deadline{};
    const std::atomic<bool>* stop = nullptr;  ///< set: give up soon and return what there is
    std::function<void(double)> progress;     ///< called with the part done, from any thread
    std::function<void(const RenderedRound&)> after_round;
};

struct Rendering {
    Film film;
    RayCounts counts;
    double samples = 0;  ///< per pixel, the mean
    double expected_error = 0;
    bool complete = false;  ///< neither stopped nor out of time
};

/// The pixels depend on scene, seed and samples alone, and on the clock where there is a deadline.
/// A stop leaves a whole if noisy picture.
Rendering render(const Scene& scene, const Intersector& intersector,
                 const EnvironmentMap& environment, const RenderOptions& options);

}  // namespace etalon
