// From camera and integrator to a film: tiles over threads, passes of samples.
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

/// Keeps the state of a rendering from time to time.
class StateKeeper {
  public:
    virtual ~StateKeeper() = default;

    /// Returns whether it is time to keep it. Called often, from any thread.
    virtual bool is_due() = 0;

    /// Keeps the state that `save` writes. Nothing is rendered meanwhile.
    virtual void keep(const std::function<void(StateWriter&)>& save) = 0;
};

/// How to watch, limit and stop a rendering while it runs. Changes no pixel but by ending early.
struct RunControl {
    Deadline deadline{};
    const std::atomic<bool>* stop = nullptr;  ///< set: give up soon and return what there is
    std::vector<RenderObserver> observers{};
    /// Gets what writes the film of the finished image, an ImageFilm.
    std::function<void(const std::function<void(StateWriter&)>&)> take_film{};
    StateKeeper* keeper = nullptr;   ///< gets the state when it is due, and when a stop ends all
    StateReader* resumed = nullptr;  ///< the state of the same rendering from which to go on
    TileDealer* dealer = nullptr;    ///< deals the tiles to this process and others
    bool estimates_error = false;    ///< passes tell an error also where no target asks for it
};

struct Rendering {
    Film film;
    RayCounts counts;                        ///< of the whole image, and of these
    RayCounts resumed_counts;                ///< those before the state from which it went on
    double samples = 0;                      ///< per pixel, the mean
    std::uint64_t dropped_samples = 0;       ///< not finite, and taken as black
    std::optional<double> expected_error{};  ///< relMSE, where it was estimated
    double resumed_samples = 0;              ///< per pixel, those before that state
    bool complete = false;  ///< what was asked for: neither stopped nor out of time
};

/// Renders the window of the settings. The integrator was made with the same settings. The pixels
/// depend on scene and settings alone, and on the clock where there is a deadline: not on when it
/// was stopped and resumed. A stop leaves a whole if noisy image. A state to resume from that does
/// not fit the image leaves one without samples.
Rendering render(const Camera& camera, const Integrator& integrator, const RenderSettings& settings,
                 const RunControl& control = {});

}  // namespace etalon
