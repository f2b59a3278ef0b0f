// Fuzzes scene readers: any text must give a valid scene or an error.
#pragma once

#include <string>
#include <string_view>

namespace etalon::fuzz {

/// Reads a text as a scene of the format and writes it in the formats that can be written. A text
/// that contains a path is skipped, so that no file outside the directory is read.
void read_scene(const std::string& format, std::string_view text);

}  // namespace etalon::fuzz
