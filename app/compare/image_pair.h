#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/numerics/vec.h"

namespace etalon::compare {

/// What two images both show of one frame.
struct ImagePair {
    int width = 0, height = 0;
    std::array<std::vector<Color>, 2> pixels;  ///< linear RGB, or display values, by rows
    std::string note{};                        ///< which part it is, if an image shows more
};

/// Reads two files of any format of read_image. A failure's reason begins with the path at fault.
Result<ImagePair> read_image_pair(const std::string& a, const std::string& b);

}  // namespace etalon::compare
