#pragma once

#include <array>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Boxes as a structure of arrays, one array for each of the six sides.
class BoxColumns {
  public:
    /// Number of unused elements at the end of each array, so that a vector load may reach beyond
    /// the last box.
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
