#pragma once

#include <OpenEXR/ImfInputFile.h>

#include <string>
#include <vector>

namespace etalon {

/// Returns the named channels of the data window, interleaved; 0 for channels that the file lacks.
/// `file` is the one at `path`, and has a value in each channel for each pixel. Throws
/// std::exception if pixels are missing or cannot be decoded.
std::vector<float> read_exr_pixels(const std::string& path, Imf::InputFile& file,
                                   const std::vector<std::string>& names);

}  // namespace etalon
