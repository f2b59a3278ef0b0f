#pragma once

#include <array>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Boxes with their sides apart, as vector instructions load them.
class BoxColumns {
  public:
    /// Rows are this much longer than there are boxes, as a vector may reach beyond the last.
    static constexpr std::size_t padding = 8;

    BoxColumns() { fit(); }

    void add(const Box3& box) {
        for (int k = 0; k < 3; ++k) {
            mins_[k][count_] = box.min[k];
            maxs_[k][count_] = box.max[k];
        }
        ++count_;
        fit();
    }

    std::size_t size() const { return count_; }
    const double* mins(int axis) const { return mins_[axis].data(); }
    const double* maxs(int axis) const { return maxs_[axis].data(); }

  private:
    void fit() {
        for (auto* rows : {&mins_, &maxs_}) {
            for (auto& row : *rows) row.resize(count_ + padding);
        }
    }

    std::size_t count_ = 0;
    std::array<std::vector<double>, 3> mins_, maxs_;
};

}  // namespace etalon
