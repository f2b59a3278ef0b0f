#pragma once

#include <string>

namespace etalon {

/// The reason why a file could not be written at `path` later on, as far as can be told now; empty
/// if it looks well. Asked before long work.
std::string obstacle_to_writing(const std::string& path);

/// Writes text to a file, whole or not at all, or to standard output for "-". False, and a message
/// on standard error, if it could not.
bool write_text(const std::string& path, const std::string& text);

}  // namespace etalon
