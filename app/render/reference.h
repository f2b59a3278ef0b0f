#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/common/stopwatch.h"
#include "core/image/metrics/metrics.h"
#include "core/render/renderer.h"

namespace etalon {

/// Error of an image against its reference over time.
class Reference {
  public:
    /// See read_reference(). The reason why there is none, or nothing.
    std::string open(const std::string& path, const RenderSettings& settings);

    /// Rendering begins.
    void start() { watch_.lap(); }

    /// Notes the errors of an image, and the times since the start without those spent in here.
    void note(const RenderedPass& pass);

    /// All metrics of the finished image.
    Metrics metrics_of(const Film& film) const;

    /// One entry for each note.
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
