#pragma once

#include <algorithm>
#include <vector>

namespace etalon {

/// Returns each value of a list once, where it is first.
template <class T>
std::vector<T> without_repeats(const std::vector<T>& list) {
    std::vector<T> once;
    for (const T& value : list) {
        if (std::ranges::find(once, value) == once.end()) once.push_back(value);
    }
    return once;
}

}  // namespace etalon
