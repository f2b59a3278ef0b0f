#include "core/scene/triangle_list.h"

#include <algorithm>

#include "core/base/make_room.h"
#include "core/scene/spare_room.h"

namespace etalon {
namespace {

template <class Difference>
void append_differences(const std::vector<TriangleIndices>& triangles, std::uint32_t base,
                        LargeVector<std::array<Difference, 3>>& to) {
    for (const auto& [a, b, c] : triangles) {
        to.push_back({static_cast<Difference>(a - base), static_cast<Difference>(b - base),
                      static_cast<Difference>(c - base)});
    }
}

}  // namespace

void TriangleList::reserve(std::size_t more) {
    make_room(narrow_, more);
}

void TriangleList::push_back(const TriangleIndices& triangle) {
    open_.push_back(triangle);
    if (open_.size() == block_size) close_block();
}

void TriangleList::close_block() {
    std::uint32_t lowest = open_[0][0], highest = lowest;
    for (const TriangleIndices& t : open_) {
        lowest = std::min({lowest, t[0], t[1], t[2]});
        highest = std::max({highest, t[0], t[1], t[2]});
    }
    const bool is_wide = highest - lowest > 0xFFFF;
    const std::size_t before = is_wide ? wide_.size() : narrow_.size();
    blocks_.push_back({lowest, static_cast<std::uint32_t>(before / block_size), is_wide});
    if (is_wide) {
        append_differences(open_, lowest, wide_);
    } else {
        append_differences(open_, lowest, narrow_);
    }
    closed_ += open_.size();
    open_.clear();
}

void TriangleList::shrink_to_fit() {
    release_spare_capacity(blocks_);
    release_spare_capacity(narrow_);
    release_spare_capacity(wide_);
    open_.shrink_to_fit();
}

std::size_t TriangleList::memory_bytes() const {
    return written_bytes(blocks_) + written_bytes(narrow_) + written_bytes(wide_) +
           open_.capacity() * sizeof(TriangleIndices);
}

}  // namespace etalon
