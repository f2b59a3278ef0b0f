// Windows of pixels, which are inclusive on both ends, as in OpenEXR.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the width and the height in pixels; 0 if the window is empty.
inline Imath::V2i window_size(const Imath::Box2i& window) {
    return window.isEmpty() ? Imath::V2i(0) : window.max - window.min + Imath::V2i(1);
}

/// Returns the number of pixels.
inline std::size_t pixel_count(const Imath::Box2i& window) {
    const Imath::V2i size = window_size(window);
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

/// Returns the pixels that two windows have in common; empty if there are none.
inline Imath::Box2i common_window(const Imath::Box2i& a, const Imath::Box2i& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

}  // namespace etalon
