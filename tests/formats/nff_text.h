// Loading NFF text in a test.
#pragma once

#include "tests/formats/messages.h"

namespace etalon {

inline const std::string good_view =
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0.01\nresolution 40 30\n";

/// `text` before a good camera.
inline LoadResult load_nff_text(const std::string& text, const LoadOptions& options = {}) {
    return load_text("nff", text + "\n" + good_view, options);
}

}  // namespace etalon
