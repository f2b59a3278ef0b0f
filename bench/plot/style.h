#pragma once

#include <string_view>

namespace etalon::plot {

/// The style sheet of all plots: CSS for what is inside an element of class "chart". Colours are
/// variables that a page may set; by themselves they are those of a white page.
///   --paper, --ink, --quiet, --rule, --edge   page, text, text of less weight, grid, frontiers
///   --colour-1 to --colour-7                   what is told apart by colour
std::string_view style();

}  // namespace etalon::plot
