// Parameters of a report: scenes, rays, samples and repeats.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/speed/plan.h"

namespace etalon::bench_report {

struct SpdScene {
    std::string family;
    std::int64_t size;
};

struct ImageRequest {
    std::string scene;  ///< below the folder of scenes
    int width, height;
    int samples;        ///< per pixel, of what is shown
    int fewer_samples;  ///< of what is compared with it
};

struct ConvergenceRequest {
    std::string scene;  ///< below the folder of scenes
    int width = 0, height = 0;
    int samples = 0;  ///< per pixel, at the end of the curves
};

/// Returns the approximate time of a scene's sample, in microseconds of a core of 2026.
double microseconds_of_sample(const std::string& scene);

struct Settings {
    std::string name;          ///< "quick" or "full"
    double seconds_limit = 0;  ///< on the wall, after which the rest is left out; 0 is no limit

    std::vector<std::string> speed_scenes;
    speed::Plan plan;

    std::vector<std::string> accuracy_backends;
    std::uint64_t case_rays;
    double case_seconds;  ///< on the wall; a case then gets fewer rays

    std::vector<std::string> frame_scenes;  ///< below the folder of scenes
    int frame_width = 0;                    ///< in pixels
    int frame_samples = 0;                  ///< per pixel
    int frame_repeats = 0;

    std::vector<SpdScene> spd_scenes;
    std::vector<std::string> spd_backends;

    std::vector<ImageRequest> images;
    std::vector<ConvergenceRequest> convergence;
    std::vector<std::string> convergence_backends;
    int convergence_seeds = 0;
};

Settings quick_settings();
Settings full_settings();

}  // namespace etalon::bench_report
