#pragma once

#include <cstddef>

namespace etalon::speed {

/// Calls f(repeat, k) for every k below `count`, forwards and backwards in turn, so that a drift of
/// the machine's speed meets all alike.
template <class F>
void alternate(int repeats, std::size_t count, const F& f) {
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t i = 0; i < count; ++i) f(repeat, repeat % 2 == 0 ? i : count - 1 - i);
    }
}

}  // namespace etalon::speed
