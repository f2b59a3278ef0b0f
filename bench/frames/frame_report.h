// The figures of frames as a table and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "bench/frames/frame_figures.h"
#include "bench/table/columns.h"

namespace etalon::frames {

/// Returns a heading, the name of each scene above a line for each of its backends, and the
/// meanings of the column names.
std::string table_of(std::span<const FrameFigures> frames, table::Detail detail);

nlohmann::ordered_json json_of(const FrameFigures& frame);

}  // namespace etalon::frames
