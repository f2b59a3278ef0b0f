// Renders from camera and integrator to a film: tiles over threads, passes of samples.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/render/deadline.h"
#include "core/render/film.h"
#include "core/render/render_observer.h"
#include "core/render/state.h"
#include "core/render/tile_dealer.h"
#include "core/scene/camera.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Saves the state of a rendering from time to time.
class StateKeeper {
  public:
    virtual ~StateKeeper() = default;

    /// Returns whether it is time to save it. Called often, from any thread.
    virtual bool is_due() = 0;

    /// Saves the state that `save` writes. Nothing is rendered meanwhile.
    virtual void keep(const std::function<void(StateWriter&)>& save) = 0;
};

/// Observers, limits and stop flag of a running rendering. They affect pixels only by ending early.
struct RunControl {
    Deadline deadline{};
    const std::atomic<bool>* stop = nullptr;  ///< if set, stop soon and return what there is
    /// Stop likewise when it is over. Unlike `deadline` it is the limit of more than this image,
    /// which is not to have the fewer samples the more of that time has passed.
    Deadline stop_at{};
    std::vector<RenderObserver> observers{};
    /// Called with a function that writes the film of the finished image, an ImageFilm.
    std::function<void(const std::function<void(StateWriter&)>&)> take_film{};
    StateKeeper* keeper = nullptr;   ///< saves the state when it is due, and at a stop
    StateReader* resumed = nullptr;  ///< state of the same rendering from which to resume
    TileDealer* dealer = nullptr;    ///< deals the tiles to this process and others
    bool estimates_error = false;    ///< estimate the error of passes even without a target
};

struct Rendering {
    Film film;
    RayCounts counts;                        ///< of the whole image
    RayCounts resumed_counts;                ///< of these, those before the resumed state
    double samples = 0;                      ///< mean per pixel
    std::uint64_t dropped_samples = 0;       ///< samples that were not finite, taken as black
    std::optional<double> expected_error{};  ///< relMSE, if it was estimated
    double resumed_samples = 0;              ///< mean per pixel, before the resumed state
    bool complete = false;                   ///< neither stopped nor out of time
    bool misses_target = false;  ///< the samples allowed were too few for the target error
};

/// Renders the window of the settings. The integrator must have been made with the same settings.
/// The pixels depend only on scene and settings, and on the clock if there is a deadline, but not
/// on stops and resumptions. A stop leaves a whole but noisier image. If the state to resume from
/// does not fit the image, the result has no samples.
Rendering render(const Camera& camera, const Integrator& integrator, const RenderSettings& settings,
                 const RunControl& control = {});

}  // namespace etalon
