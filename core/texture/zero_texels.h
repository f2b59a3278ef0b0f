#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/texture.h"

namespace etalon {

/// Which texels of an image are 0, a bit for each: all that must be kept of one that only tells
/// where holes are.
class ZeroTexels {
  public:
    /// Of an image of zeros.
    ZeroTexels(int width, int height, Wrap wrap);

    /// Notes that a texel, given by its number by rows from the top, is not 0.
    void set_not_zero(std::size_t texel) { words_[texel / 64] |= std::uint64_t{1} << texel % 64; }

    /// Returns whether the value that is interpolated at (s, t) is 0.
    bool is_zero(const Vec2& st) const;

    std::size_t memory_bytes() const { return words_.size() * sizeof(std::uint64_t); }

  private:
    int width_, height_;
    Wrap wrap_;
    std::vector<std::uint64_t> words_;  ///< a set bit is a texel that is not 0
};

}  // namespace etalon
