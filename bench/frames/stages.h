// The stages of a frame, as in its table, its JSON and the report.
#pragma once

#include <span>

#include "bench/frames/frame_figures.h"

namespace etalon::frames {

struct Stage {
    const char* key;      ///< in JSON and in the report
    const char* heading;  ///< in a narrow column
    int width;            ///< of that column
    const char* meaning;
    double (*seconds)(const FrameFigures& frame);
};

/// Returns all stages in the order of time; the rendering comes after its parts.
std::span<const Stage> stages();

}  // namespace etalon::frames
