#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include <nlohmann/json.hpp>

#include "core/render/render_observer.h"

namespace etalon {

/// Progress of a rendering, and its error over time, for the page that shows it.
class ViewState {
  public:
    /// The last two tell whether the image was written.
    enum class Stage { preparing, rendering, writing, over, unwritten };

    RenderObserver observer();

    void set_stage(Stage stage);
    Stage stage() const;

    /// Returns "stage", "seconds" since the rendering began, the completed "part", and "errors", a
    /// list of "seconds" and "relmse".
    nlohmann::ordered_json json() const;

  private:
    using Clock = std::chrono::steady_clock;
    double seconds() const;

    mutable std::mutex mutex_;
    Stage stage_ = Stage::preparing;
    Clock::time_point start_, end_;
    double part_ = 0;
    nlohmann::ordered_json errors_ = nlohmann::ordered_json::array();
};

}  // namespace etalon
