// Scene files: whatever is in them, a sane scene or an error.
#pragma once

#include <string>
#include <string_view>

namespace etalon::fuzz {

/// Reads a text as a scene of the format, and writes it in the formats that can be written. A text
/// that names files with a path is passed over: nothing outside of the folder is read.
void read_scene(const std::string& format, std::string_view text);

}  // namespace etalon::fuzz
