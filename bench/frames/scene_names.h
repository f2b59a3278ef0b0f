// Names of scenes by which reports tell them apart.
#pragma once

#include <string>
#include <vector>

namespace etalon::frames {

/// Returns a short name for one of the scenes: its file's name without extension, after as many of
/// its folders as no other scene has alike; the whole path if that is not enough.
std::string short_name(const std::string& scene, const std::vector<std::string>& scenes);

}  // namespace etalon::frames
