#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/common/stopwatch.h"
#include "core/image/metrics/metrics.h"
#include "core/render/renderer.h"

namespace etalon {

/// Error of an image relative to its reference, over time.
class Reference {
  public:
    /// Reads the reference: see read_reference(). Returns why that failed, or an empty string.
    std::string open(const std::string& path, const RenderSettings& settings);

    /// Starts the clock, when rendering begins.
    void start() { watch_.lap(); }

    /// Records the errors of an image, and the time since the start without that spent in here.
    void note(const RenderedPass& pass);

    /// Returns all metrics of the finished image.
    Metrics metrics_of(const Film& film) const;

    /// Returns one entry for each call of note().
    const nlohmann::ordered_json& history() const { return history_; }

  private:
    RenderSettings settings_;
    int width_ = 0;
    std::vector<Color> pixels_;
    Stopwatch watch_;
    Duration spent_;
    nlohmann::ordered_json history_ = nlohmann::ordered_json::array();
};

}  // namespace etalon
