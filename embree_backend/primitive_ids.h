#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// The scene's numbers of the primitives in one Embree geometry. Where they are 0, 1, 2, ... as
/// Embree's are, nothing is stored: looking them up would cost a cache miss a hit.
class PrimitiveIds {
  public:
    /// `ids` in ascending order.
    explicit PrimitiveIds(std::vector<std::uint32_t> ids) : ids_(std::move(ids)) {
        if (!ids_.empty() && ids_.back() == ids_.size() - 1) ids_ = {};
    }
    PrimitiveIds() = default;

    std::uint32_t operator[](std::uint32_t index) const {
        return ids_.empty() ? index : ids_[index];
    }

    std::size_t memory_bytes() const { return ids_.size() * sizeof(std::uint32_t); }

  private:
    std::vector<std::uint32_t> ids_;
};

}  // namespace etalon
