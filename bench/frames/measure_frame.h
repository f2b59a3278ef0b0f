#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "bench/frames/frame_figures.h"
#include "core/base/result.h"
#include "core/render/deadline.h"

namespace etalon::frames {

/// What to measure for each scene.
struct FrameConfig {
    int repeats = 5;
    int width = 0;    ///< of the image in pixels, with the scene's aspect; 0: the scene's
    int samples = 0;  ///< per pixel; 0: the scene's
    std::vector<std::string> backends;  ///< empty: the scene's
    std::string image;                  ///< path of the EXR that is written and replaced
    /// If set, returns why a scene made of these files must not be measured, or nothing.
    std::function<std::string(const std::vector<std::string>&)> check_files{};
    const std::atomic<bool>* stop = nullptr;  ///< if set, stop soon, with fewer repeats
    Deadline deadline{};                      ///< likewise if it is over

    bool is_over() const { return (stop != nullptr && *stop) || deadline.is_over(); }
};

/// Loads a scene, a file or a name of bench_scene(), and measures its frame with each backend on
/// one thread. Messages about the scene go to standard error. If it is over early, backends have
/// fewer repeats, and those that would have none are left out.
Result<std::vector<FrameFigures>> measure_frame(const std::string& scene,
                                                const FrameConfig& config);

}  // namespace etalon::frames
