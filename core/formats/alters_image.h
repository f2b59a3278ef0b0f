#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

#include "core/formats/diagnostic.h"

namespace etalon {

/// Returns whether a diagnostic means that the image is not that of the scene's file: a shape is
/// left out, something stands in for what is not rendered, or a motion is ignored.
inline bool alters_image(const Diagnostic& diagnostic) {
    constexpr std::string_view kinds[] = {"stand-in", "motion", "shape"};
    return std::ranges::find(kinds, diagnostic.kind) != std::end(kinds);
}

}  // namespace etalon
