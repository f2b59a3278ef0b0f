#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/numerics/vec.h"

namespace etalon::compare {

/// The part of a frame that two images both show.
struct ImagePair {
    int width = 0, height = 0;
    std::array<std::vector<Color>, 2> pixels;  ///< linear RGB, or display values, by rows
    bool has_display_values = false;
    std::optional<Imath::Box2i> window{};  ///< the part, if an image shows more
};

/// Reads two files of any format of read_image. A failure's reason begins with the path at fault.
Result<ImagePair> read_image_pair(const std::string& a, const std::string& b);

}  // namespace etalon::compare
