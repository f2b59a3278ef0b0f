// Reproducible random numbers: the standard's distributions differ between libraries.
#pragma once

#include <random>

#include "core/numerics/vec.h"

namespace etalon {

class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    double uniform(double low = 0, double high = 1) {
        return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11), -53);
    }
    int index(std::size_t count) { return static_cast<int>(bits_() % count); }
    double sign() { return (bits_() & 1) != 0 ? 1 : -1; }

    Vec3 in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

    /// Of unit length.
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube();
            const double length2 = v.dot(v);
            if (length2 > 0.01 && length2 <= 1) return v / std::sqrt(length2);
        }
    }

  private:
    std::mt19937_64 bits_;
};

}  // namespace etalon
