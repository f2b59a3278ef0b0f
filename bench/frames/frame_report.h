// The figures of frames as a table and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "bench/frames/frame_figures.h"

namespace etalon::frames {

std::string table(std::span<const FrameFigures> frames);

nlohmann::ordered_json json_of(const FrameFigures& frame);

}  // namespace etalon::frames
