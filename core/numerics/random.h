// A random generator so small that every ray of millions has its own and can be generated again
// from its number alone.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// SplitMix64 (Steele, Lea & Flood 2014, "Fast Splittable Pseudorandom Number Generators"). It
/// gives the same numbers with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed, std::uint64_t number = 0)
        : state_(seed + number * 0xd1342543de82ef95U) {
        bits();
    }

    /// Returns the next 64 random bits.
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }

    double uniform(double low = 0, double high = 1) {
        return low + (high - low) * std::ldexp(static_cast<double>(bits() >> 11), -53);
    }

    /// Returns a random index in [0, count), where 0 < count <= 2^32.
    std::uint32_t index(std::size_t count) { return static_cast<std::uint32_t>(bits() % count); }
    bool one_in(std::size_t count) { return index(count) == 0; }
    int axis() { return static_cast<int>(index(3)); }
    double sign() { return (bits() & 1) != 0 ? 1 : -1; }

    /// Returns a random number from 10^low to 10^high, uniformly distributed in the exponent.
    double magnitude(double low, double high) { return std::pow(10.0, uniform(low, high)); }

    /// Returns a random point of the cube [-half, half]^3.
    Vec3 in_cube(double half = 1) {
        const double x = uniform(-half, half), y = uniform(-half, half), z = uniform(-half, half);
        return {x, y, z};
    }

    /// Returns a random direction of unit length.
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube();
            const double length2 = v.dot(v);
            if (length2 > 0.01 && length2 <= 1) return v / std::sqrt(length2);
        }
    }

  private:
    std::uint64_t state_;
};

}  // namespace etalon
