// Small files that between them have every kind of statement.
#pragma once

#include <string>
#include <vector>

namespace etalon::pbrt {

/// The first is without fault, the second names what it does not define and has two frames.
const std::vector<std::string>& whole_files();

}  // namespace etalon::pbrt
