#pragma once

#include <cstdint>
#include <string>

namespace etalon::generate {

/// Returns the text of a scene of a family, which must be one of families(), in memory.
std::string scene_text(const std::string& family, std::int64_t size);

}  // namespace etalon::generate
