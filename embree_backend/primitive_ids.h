#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// The scene's numbers of the primitives in one Embree geometry. If they are consecutive like
/// Embree's, as those of instances are, only the first is stored: a look-up would cost a cache miss
/// for each hit.
class PrimitiveIds {
  public:
    /// `ids` must be in ascending order.
    explicit PrimitiveIds(std::vector<std::uint32_t> ids) : ids_(std::move(ids)) {
        if (ids_.empty() || ids_.back() - ids_.front() != ids_.size() - 1) return;
        first_ = ids_.front();
        ids_ = {};
    }
    PrimitiveIds() = default;

    std::uint32_t operator[](std::uint32_t index) const {
        return ids_.empty() ? first_ + index : ids_[index];
    }

    std::size_t memory_bytes() const { return ids_.size() * sizeof(std::uint32_t); }

  private:
    std::vector<std::uint32_t> ids_;
    std::uint32_t first_ = 0;
};

}  // namespace etalon
