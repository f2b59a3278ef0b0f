#pragma once

#include <string_view>

namespace etalon::plot {

/// Returns the style sheet of all plots: CSS for the contents of an element of class "chart".
/// Colours are variables that a page may set, each with a default, which is for a white page:
///   --paper, --ink, --quiet, --rule, --edge   page, text, secondary text, grid, frontiers
///   --colour-1 to --colour-7                  series
std::string_view style();

}  // namespace etalon::plot
