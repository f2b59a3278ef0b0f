#pragma once

#include <cstdint>

namespace etalon::pbrt {

/// Location of a statement or parameter in the files read.
struct FileLoc {
    std::uint32_t file = 0;  ///< number in ParsedFile::files
    int line = 0;            ///< from 1; 0 for a default, which no file contains
    int column = 0;          ///< number from 1, in bytes
};

}  // namespace etalon::pbrt
