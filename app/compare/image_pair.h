#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/numerics/vec.h"

namespace etalon::compare {

/// Two images of one size and, where both files say where in their frame they are, of one place.
struct ImagePair {
    int width = 0, height = 0;
    std::array<std::vector<Color>, 2> pixels;  ///< linear RGB, or display values, by rows
};

/// Reads two files of any format of read_image. A failure's reason begins with the path at fault.
Result<ImagePair> read_image_pair(const std::string& a, const std::string& b);

}  // namespace etalon::compare
