#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/texture.h"

namespace etalon {

/// One bit for each texel of an image that tells whether it is 0: all that is needed of an image
/// that only defines holes.
class ZeroTexels {
  public:
    /// Makes an image of zeros.
    ZeroTexels(int width, int height, Wrap wrap);

    /// Marks a texel, given by its number in rows from the top, as not 0.
    void set_not_zero(std::size_t texel) { words_[texel / 64] |= std::uint64_t{1} << texel % 64; }

    /// Returns whether the value that is interpolated at (s, t) is 0.
    bool is_zero(const Vec2& st) const;

    std::size_t memory_bytes() const { return words_.size() * sizeof(std::uint64_t); }

  private:
    int width_, height_;
    Wrap wrap_;
    std::vector<std::uint64_t> words_;  ///< 1 for a texel that is not 0
};

}  // namespace etalon
