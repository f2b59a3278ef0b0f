#pragma once

#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns a PNG of how much each pixel of the window costs, by rows. The most expensive one is as
/// bright as can be, and what costs a 256th of it or less is black: brightness goes by the
/// logarithm.
std::string cost_map(const Imath::Box2i& window, const std::vector<double>& costs);

}  // namespace etalon
