// Loading PRT text in a test.
#pragma once

#include "tests/formats/messages.h"

namespace etalon {

/// Five lines.
inline const std::string good_lines =
    "from 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 40 30\n";

/// Surfaces of diffuse colours that tell shapes apart, here red and green.
inline const std::string red = "surface 0 0 0 0 0 0 0 0 0 0 0 1 0 0 0 0 0 0 0\n";
inline const std::string green = "surface 0 0 0 0 0 0 0 0 0 0 0 0 1 0 0 0 0 0 0\n";
inline const std::string glass = "surface 1 1 1 .1 1 1 1 .9 0 0 0 0 0 0 0 0 0 0 1.5\n";

/// `text` after a good camera, from line 6 on.
inline LoadResult load_prt_text(const std::string& text, const LoadOptions& options = {}) {
    return load_text("prt", good_lines + text, options);
}

}  // namespace etalon
