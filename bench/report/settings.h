// How thoroughly a report is made.
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

struct PictureRequest {
    std::string scene;  ///< below the folder of scenes
    int width, height;
    int samples;  ///< per pixel
};

struct Settings {
    std::string name;      ///< "quick" or "full"
    double seconds_limit;  ///< on the wall; what is not begun by then is left out

    std::vector<std::string> speed_scenes;
    speed::Plan plan;

    std::vector<std::string> accuracy_backends;
    std::uint64_t case_rays;
    double case_seconds;  ///< on the wall; a case then gets fewer rays

    std::vector<SpdScene> spd_scenes;
    std::vector<std::string> spd_backends;

    std::vector<PictureRequest> pictures;
};

Settings quick_settings();
Settings full_settings();

}  // namespace etalon::bench_report
