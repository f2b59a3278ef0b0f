#pragma once

#include <optional>
#include <string>

#include "bench/frames/frame_figures.h"
#include "core/base/result.h"

namespace etalon::frames {

/// What to measure of each scene.
struct Plan {
    int repeats = 5;
    int width = 0;        ///< of the image in pixels, the height follows; 0: the scene's
    std::string backend;  ///< empty: the scene's
};

/// Measures a frame of the scene, a file or a name of bench_scene(), on one thread. Messages of the
/// loader go to standard error.
Result<FrameFigures> measure_frame(const std::string& scene, const Plan& plan);

}  // namespace etalon::frames
