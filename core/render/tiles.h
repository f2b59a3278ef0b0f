// A window of pixels divided into tiles, and the one loop that distributes tiles to threads.
#pragma once

#include <algorithm>
#include <vector>

#include "core/numerics/vec.h"
#include "core/parallel/parallel.h"

namespace etalon {

/// Number of pixels on a side of a tile.
inline constexpr int tile_side = 16;

/// Divides a window of pixels, inclusive on both ends, into square tiles, in rows. The first begins
/// at `corner`, which is at the window's corner or before it.
inline std::vector<Imath::Box2i> tiles_of(const Imath::Box2i& window, const Imath::V2i& corner) {
    constexpr int side = tile_side;
    std::vector<Imath::Box2i> tiles;
    for (int y = corner.y; y <= window.max.y; y += side) {
        for (int x = corner.x; x <= window.max.x; x += side) {
            const Imath::V2i first(std::max(x, window.min.x), std::max(y, window.min.y));
            const Imath::V2i last(std::min(x + side - 1, window.max.x),
                                  std::min(y + side - 1, window.max.y));
            tiles.emplace_back(first, last);
        }
    }
    return tiles;
}

inline std::vector<Imath::Box2i> tiles_of(const Imath::Box2i& window) {
    return tiles_of(window, window.min);
}

/// Calls visit(i, tiles[i]) for every tile, on all threads, until `stopped()`.
template <class Stopped, class Visit>
void for_each_tile(const std::vector<Imath::Box2i>& tiles, const Stopped& stopped,
                   const Visit& visit) {
    parallel_for(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !stopped(); ++i) visit(i, tiles[i]);
    });
}

/// Calls visit(x, y) for every pixel of a tile, by rows, until `stopped()` at the end of a row.
template <class Stopped, class Visit>
void for_each_pixel(const Imath::Box2i& tile, const Stopped& stopped, const Visit& visit) {
    for (int y = tile.min.y; y <= tile.max.y && !stopped(); ++y) {
        for (int x = tile.min.x; x <= tile.max.x; ++x) visit(x, y);
    }
}

template <class Visit>
void for_each_pixel(const Imath::Box2i& tile, const Visit& visit) {
    for_each_pixel(
        tile, [] { return false; }, visit);
}

}  // namespace etalon
