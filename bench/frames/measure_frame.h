#pragma once

#include <string>

#include "bench/frames/frame_figures.h"
#include "core/base/result.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon::frames {

/// What to measure of each scene.
struct Plan {
    int repeats = 5;
    int width = 0;        ///< of the image in pixels, the height follows; 0: the scene's
    int samples = 0;      ///< per pixel; 0: the scene's
    std::string backend;  ///< empty: the scene's
};

/// Measures a frame of a scene on one thread, every part so many times: all but its name and what
/// loading it took.
FrameFigures measure_frame(const Scene& scene, const RenderSettings& settings, int repeats);

/// Loads a scene, a file or a name of bench_scene(), and measures its frame. Messages of the loader
/// go to standard error.
Result<FrameFigures> measure_frame(const std::string& scene, const Plan& plan);

}  // namespace etalon::frames
