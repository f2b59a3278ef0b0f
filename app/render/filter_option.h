#pragma once

#include <string>
#include <vector>

#include "core/scene/pixel_filter.h"

namespace etalon {

/// Returns the names of all filters.
std::vector<std::string> filter_names();

/// Returns the help text of --filter, with names and default radii.
std::string filter_help();

/// Returns what is wrong with a filter's NAME[:RADIUS], beginning with the text, or an empty
/// string.
std::string check_filter(const std::string& text);

/// Sets the filter to NAME with its default parameters and RADIUS, or its default radius. The text
/// must pass check_filter().
void apply_filter(const std::string& text, PixelFilter& filter);

}  // namespace etalon
