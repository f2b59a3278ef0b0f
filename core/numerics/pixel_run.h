#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Samples of one pixel in a batch: those with the indices [first, last) there.
struct PixelRun {
    Imath::V2i pixel;
    std::uint32_t first, last;

    std::uint32_t size() const { return last - first; }
};

}  // namespace etalon
