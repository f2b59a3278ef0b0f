// Loading SCE text in a test.
#pragma once

#include "tests/formats/messages.h"

namespace etalon {

inline LoadResult load_sce_text(const std::string& text, const LoadOptions& options = {}) {
    return load_text("sce", text, options);
}

/// A triangle to be put under a matrix.
inline const std::string unit_triangle = "triangle 0 0 0 1 0 0 0 1 0\n";

}  // namespace etalon
