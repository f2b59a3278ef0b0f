#pragma once

#include <string>

namespace etalon {

/// Returns the best instruction set that traversals are compiled for and this machine has: "avx2",
/// "sse4", "neon", ...
std::string traversal_isa();

}  // namespace etalon
