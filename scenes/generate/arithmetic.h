// Arithmetic of the families. Only operations that IEEE 754 rounds correctly are used, no libm
// functions and no std::random distributions: a scene's text is the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon::generate {

/// Returns (cos, sin) of an angle given in turns, to a few units in the last place; exact at
/// quarter turns. The Taylor series after reduction to an eighth of a turn either side of a
/// quarter.
inline Vec2 on_circle(double turns) {
    constexpr double two_pi = 6.283185307179586;
    const double quarter = std::floor(4 * turns + 0.5);
    const double angle = two_pi * (turns - quarter / 4);
    double cosine = 1;
    double sine = 1;
    for (int k = 20; k > 0; k -= 2) {
        cosine = 1 - cosine * angle * angle / (k * (k - 1));
        sine = 1 - sine * angle * angle / (k * (k + 1));
    }
    sine *= angle;
    switch (static_cast<std::int64_t>(quarter) & 3) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

/// Returns the cube root of x >= 1, by Newton's method from above.
inline double cube_root(double x) {
    double root = x;
    for (double next = (2 * root + x / (root * root)) / 3; next < root;
         next = (2 * root + x / (root * root)) / 3) {
        root = next;
    }
    return root;
}

/// Scrambles 64 bits (the finaliser of SplitMix64: Steele, Lea & Flood 2014).
constexpr std::uint64_t scramble(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31);
}

/// Returns a number in [-1, 1) that is a pure function of its two keys.
constexpr double noise(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t bits = scramble(scramble(a + 0x9E3779B97F4A7C15U) + b);
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

/// Returns a point of the cube [-1, 1)^3, likewise.
constexpr Vec3 noise_point(std::uint64_t a, std::uint64_t b) {
    return {noise(a, 3 * b), noise(a, 3 * b + 1), noise(a, 3 * b + 2)};
}

}  // namespace etalon::generate
