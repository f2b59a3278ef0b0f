#pragma once

#include <cstddef>
#include <functional>

namespace etalon::speed {

/// Calls f(repeat, k) for every k below `count`, alternately forwards and backwards, so that a
/// drift of the machine's speed affects all alike. Returns the number of repeats for which every
/// call was made before it was over.
template <class F>
int alternate(int repeats, std::size_t count, const std::function<bool()>& is_over, const F& f) {
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t i = 0; i < count; ++i) {
            if (is_over()) return repeat;
            f(repeat, repeat % 2 == 0 ? i : count - 1 - i);
        }
    }
    return repeats;
}

}  // namespace etalon::speed
