#pragma once

#include <atomic>
#include <string>

#include "bench/frames/frame_figures.h"
#include "core/base/result.h"

namespace etalon::frames {

/// What to measure for each scene.
struct Plan {
    int repeats = 5;
    int width = 0;        ///< of the image in pixels, with the scene's aspect; 0: the scene's
    int samples = 0;      ///< per pixel; 0: the scene's
    std::string backend;  ///< empty: the scene's
    const std::atomic<bool>* stop = nullptr;  ///< if set, stop soon, with fewer repeats
};

/// Loads a scene, a file or a name of bench_scene(), and measures its frame on one thread. Messages
/// of the loader go to standard error. A stop keeps the repeats until then, possibly none.
Result<FrameFigures> measure_frame(const std::string& scene, const Plan& plan);

}  // namespace etalon::frames
