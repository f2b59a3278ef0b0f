#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace etalon {

/// The reason why a file could not be written at `path` later on, as far as can be told now; empty
/// if it looks well. Asked before long work.
std::string check_writable(const std::string& path);

/// Returns why these outputs cannot all be had, as far as can be told now, and the exit status for
/// that; an empty text if they can. "-" is standard output, which holds one of them at most; empty
/// paths stand for outputs that nobody asked for.
std::pair<std::string, int> check_outputs(const std::vector<std::string>& paths);

/// Returns why standard output should get no bytes of an image: it is a terminal. Empty if it may.
std::string check_image_to_standard_output();

/// Writes text to a file, whole or not at all, or to standard output for "-". False, and a message
/// on standard error, if it could not.
bool write_text(const std::string& path, const std::string& text);

/// The same for JSON, indented. Names of files that are not UTF-8 lose what is not.
bool write_json(const std::string& path, const nlohmann::ordered_json& json);

/// Writes a table to standard output, or to standard error where `json`, the file for the same
/// results, is "-" and another program is to read them from standard output.
void write_table(const std::string& json, const std::string& table);

}  // namespace etalon
