#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace etalon {

/// Returns why a file cannot be written at `path`, as far as can be told in advance; empty if it
/// looks writable. Called before long work.
std::string check_writable(const std::string& path);

/// Returns whether results so far may be written to a path and replaced by others later: not where
/// they go to standard output, a stream, a pipe or a device.
bool is_replaceable(const std::string& path);

/// Returns which file is given for two outputs, or for an output and an input; empty if none is.
/// Devices may be both.
std::string find_clash(const std::vector<std::string>& outputs,
                       const std::vector<std::string>& inputs);

/// Returns why these outputs cannot all be written, as far as can be told in advance, and the exit
/// status for that; an empty text if they can. "-" is standard output, which can take only one of
/// them; empty paths are files that were not requested.
std::pair<std::string, int> check_outputs(const std::vector<std::string>& outputs,
                                          const std::vector<std::string>& inputs);

/// Returns why standard output should not get the bytes of an image: it is a terminal. Empty if it
/// may, as under mpirun, whose terminals pass all bytes on to wherever its own output goes.
std::string check_image_to_standard_output();

/// Writes text to a file, completely or not at all, or to standard output for "-". Returns false,
/// after a message on standard error, if it failed.
bool write_text(const std::string& path, const std::string& text);

/// The same for JSON, indented. Bytes of file names that are not UTF-8 are replaced.
bool write_json(const std::string& path, const nlohmann::ordered_json& json);

/// Writes a table to standard output; to standard error if `json`, the file for the same results,
/// is "-", so that another program can read standard output.
void write_table(const std::string& json, const std::string& table);

}  // namespace etalon
