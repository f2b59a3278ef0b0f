#pragma once

#include <string>
#include <vector>

#include "core/scene/pixel_filter.h"

namespace etalon {

/// The names of all filters.
std::vector<std::string> filter_names();

/// Help text of --filter, with names and usual radii.
std::string filter_help();

/// Returns what is wrong with a filter's NAME[:RADIUS], beginning with the text, or nothing.
std::string check_filter(const std::string& text);

/// Sets the filter to NAME with its usual parameters and RADIUS, or the usual one. The text must
/// be one in which check_filter() finds nothing wrong.
void apply_filter(const std::string& text, PixelFilter& filter);

}  // namespace etalon
