#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// Replaces the contents of the file at `path`, completely or not at all. The new contents are
/// written beside it and then renamed, so that a reader (or a power cut) finds the old file or the
/// new one. Any number of threads and processes may write the same path; the last rename wins. A
/// new file gets the permissions that the umask leaves, a replaced one keeps its own, and a link to
/// a file stays a link. Devices and pipes are written in place, and a file to which a stream was
/// redirected is written through that stream. A file that the system lets no other replace, such as
/// a mount point, is overwritten. Returns the reason of a failure, after which no
/// temporary file is left, or an empty string.
std::string write_file_atomically(const std::string& path, std::string_view content);

}  // namespace etalon
