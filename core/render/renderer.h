// From camera and integrator to a film: tiles over threads, passes of samples.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/deadline.h"
#include "core/render/film.h"
#include "core/render/render_observer.h"
#include "core/scene/camera.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// How to watch, limit and stop a rendering while it runs. Changes no pixel but by ending early.
struct RunControl {
    Deadline deadline{};
    const std::atomic<bool>* stop = nullptr;  ///< set: give up soon and return what there is
    std::vector<RenderObserver> observers{};
    bool estimates_error = false;  ///< passes tell an error also where no target asks for it
};

struct Rendering {
    Film film;
    RayCounts counts;
    double samples = 0;                      ///< per pixel, the mean
    std::uint64_t dropped_samples = 0;       ///< not finite, and taken as black
    std::optional<double> expected_error{};  ///< relMSE, where it was estimated
    bool complete = false;  ///< what was asked for: neither stopped nor out of time
};

/// Renders the window of the settings. The integrator was made with the same settings. The pixels
/// depend on scene and settings alone, and on the clock where there is a deadline. A stop leaves a
/// whole if noisy image.
Rendering render(const Camera& camera, const Integrator& integrator, const RenderSettings& settings,
                 const RunControl& control = {});

}  // namespace etalon
