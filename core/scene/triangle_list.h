#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/parallel/large_pages.h"
#include "core/scene/value_iterator.h"

namespace etalon {

/// Vertex numbers of a triangle's corners.
using TriangleIndices = std::array<std::uint32_t, 3>;

/// Many triples of vertex numbers, in blocks that store differences to their smallest number: in 16
/// bits each where that suffices, as in a mesh of up to 65 536 vertices.
class TriangleList {
  public:
    using value_type = TriangleIndices;

    std::size_t size() const { return closed_ + open_.size(); }
    bool empty() const { return size() == 0; }
    /// Reserves space for `more` triangles, if they need 16 bits for each number.
    void reserve(std::size_t more);
    void push_back(const TriangleIndices& triangle);

    TriangleIndices operator[](std::size_t i) const {
        if (i >= closed_) return open_[i - closed_];
        const std::size_t place = i % block_size;
        const Block& block = blocks_[i / block_size];
        return block.is_wide ? decoded(wide_, block, place) : decoded(narrow_, block, place);
    }

    ValueIterator<TriangleList> begin() const { return {*this, 0}; }
    ValueIterator<TriangleList> end() const { return {*this, size()}; }

    void shrink_to_fit();
    std::size_t memory_bytes() const;

  private:
    static constexpr std::size_t block_size = 64;

    struct Block {
        std::uint32_t base;   ///< the smallest number
        std::uint32_t first;  ///< number of the block in `narrow_` or `wide_`
        bool is_wide;
    };

    template <class Difference>
    static TriangleIndices decoded(const LargeVector<std::array<Difference, 3>>& differences,
                                   const Block& block, std::size_t place) {
        const auto& d = differences[block.first * block_size + place];
        return {block.base + d[0], block.base + d[1], block.base + d[2]};
    }

    void close_block();

    LargeVector<Block> blocks_;
    LargeVector<std::array<std::uint16_t, 3>> narrow_;
    LargeVector<std::array<std::uint32_t, 3>> wide_;
    std::size_t closed_ = 0;             ///< number of triangles in blocks
    std::vector<TriangleIndices> open_;  ///< triangles of the last block while it is not full
};

}  // namespace etalon
