#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/image/image.h"

namespace etalon {

/// Fills `bytes`, which must be empty, with rows of `row` bytes by read(first, count), a few at a
/// time. read() returns false on failure. Memory grows with the contents of the file, whatever its
/// header claims. Returns whether all rows were read.
template <class Read>
bool read_by_rows(std::size_t row, int height, const Read& read, PixelBytes& bytes) {
    constexpr int rows_at_once = 64;
    const std::size_t size = row * static_cast<std::size_t>(height);
    bytes.reserve(size);
    for (int y = 0; y < height; y += rows_at_once) {
        const int count = std::min(rows_at_once, height - y);
        const std::size_t done = bytes.size();
        bytes.resize(done + row * static_cast<std::size_t>(count));
        if (!read(&bytes[done], count)) return false;
    }
    return true;
}

}  // namespace etalon
