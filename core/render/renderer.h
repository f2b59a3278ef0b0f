// From a scene to a film: tiles over threads, passes over samples.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "core/intersect/intersector.h"
#include "core/render/film.h"
#include "core/render/ray_counts.h"
#include "core/shading/environment_map.h"

namespace etalon {

struct RenderOptions {
    int samples_per_pixel = 0;  ///< 0: the camera's PixelRays
    int max_depth = 5;          ///< rays in a row, the eye's included
    std::uint32_t seed = 0;
    Imath::Box2i window;                      ///< pixels to render, inclusive on both ends
    const std::atomic<bool>* stop = nullptr;  ///< set: give up soon and return what there is
    std::function<void(double)> progress;     ///< called with the part done, from any thread
};

struct Rendering {
    Film film;
    RayCounts counts;
    int samples = 0;  ///< per pixel, of the last pass that was finished
    bool complete = false;
};

/// The pixels depend on scene, seed and samples alone. Passes double the samples, so that a stop
/// leaves a whole if noisy picture.
Rendering render(const Scene& scene, const Intersector& intersector,
                 const EnvironmentMap& environment, const RenderOptions& options);

}  // namespace etalon
