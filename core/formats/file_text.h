#pragma once

#include <string>

namespace etalon {

/// The bytes of a file, or why there are none.
struct FileText {
    std::string text;
    std::string error;  ///< empty on success
};

/// Reads a whole file; "-" is standard input.
FileText read_file(const std::string& path);

}  // namespace etalon
