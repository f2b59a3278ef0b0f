#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// Gives the file at `path` this content, whole or not at all: it is written beside its place and
/// then renamed, so a reader (or a power cut) finds the old file or the new one. Any number of
/// threads and processes may write the same path; the last rename stays. A new file gets the
/// permissions the umask leaves, a replaced one keeps its own, and a link to a file stays a link.
/// Devices and pipes are written in place. Returns the reason of a failure, after which nothing is
/// left behind, or an empty string.
std::string write_file_atomically(const std::string& path, std::string_view content);

}  // namespace etalon
