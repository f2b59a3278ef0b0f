#pragma once

#include <cstddef>
#include <functional>

namespace etalon::speed {

/// Calls f(repeat, k) for every k below `count`, alternately forwards and backwards, so that a
/// drift of the machine's speed affects all alike. Returns false if it was over before the last
/// call.
template <class F>
bool alternate(int repeats, std::size_t count, const std::function<bool()>& is_over, const F& f) {
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t i = 0; i < count; ++i) {
            if (is_over()) return false;
            f(repeat, repeat % 2 == 0 ? i : count - 1 - i);
        }
    }
    return true;
}

}  // namespace etalon::speed
