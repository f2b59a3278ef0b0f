#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// The scene's numbers of the primitives in one Embree geometry. If they are 0, 1, 2, ... like
/// Embree's, nothing is stored: a look-up would cost a cache miss for each hit.
class PrimitiveIds {
  public:
    /// `ids` must be in ascending order.
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
