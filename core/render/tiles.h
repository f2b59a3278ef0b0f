#pragma once

#include <algorithm>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// A window of pixels, inclusive on both ends, cut into what threads take at a time.
inline std::vector<Imath::Box2i> tiles_of(const Imath::Box2i& window) {
    constexpr int side = 16;
    std::vector<Imath::Box2i> tiles;
    for (int y = window.min.y; y <= window.max.y; y += side) {
        for (int x = window.min.x; x <= window.max.x; x += side) {
            const Imath::V2i last(std::min(x + side - 1, window.max.x),
                                  std::min(y + side - 1, window.max.y));
            tiles.emplace_back(Imath::V2i(x, y), last);
        }
    }
    return tiles;
}

}  // namespace etalon
