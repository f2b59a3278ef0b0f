// Small files that together have every kind of statement.
#pragma once

#include <string>
#include <vector>

namespace etalon::pbrt {

/// The first has no error; the second uses undefined names and has two frames.
const std::vector<std::string>& whole_files();

}  // namespace etalon::pbrt
