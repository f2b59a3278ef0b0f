// A loader: text whose lines are the centre and the radius of a ball.
#pragma once

#include <string>

#include "core/formats/load.h"

namespace laboratory {

/// Returns a scene of the balls, seen from the front, or what is wrong with the text.
etalon::LoadResult load_balls(const std::string& text, const std::string& path);

}  // namespace laboratory
