#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon::test {

/// SplitMix64 (Steele, Lea & Flood 2014): the same numbers with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }

    /// In [0, n).
    std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(bits() % n); }
    bool one_in(std::size_t n) { return below(n) == 0; }

    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    }

    /// Evenly spread over the orders of magnitude from 10^low to 10^high.
    double magnitude(double low, double high) { return std::pow(10, between(low, high)); }

    Vec3 in_cube(double half = 1) {
        const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
        return {x, y, z};
    }

    /// Never zero.
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube();
            const double length2 = v.dot(v);
            if (length2 > 0.01 && length2 < 1) return v / std::sqrt(length2);
        }
    }

  private:
    std::uint64_t state_;
};

}  // namespace etalon::test
