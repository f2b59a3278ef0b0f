#pragma once

#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns a PNG of the cost of each pixel of the window, in rows. The most expensive pixel has
/// full brightness, a 256th of its cost or less is black, and brightness is logarithmic in between.
std::string cost_map(const Imath::Box2i& window, const std::vector<double>& costs);

}  // namespace etalon
