#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace etalon {

/// Returns the median of values, of which there is at least one; of two in the middle the larger.
template <class T>
T median_of(std::vector<T> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace etalon
