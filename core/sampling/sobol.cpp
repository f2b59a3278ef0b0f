#include "core/sampling/sobol.h"

namespace etalon {
namespace {

std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffU) << 8) | ((x & 0xff00ff00U) >> 8);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x & 0xf0f0f0f0U) >> 4);
    x = ((x & 0x33333333U) << 2) | ((x & 0xccccccccU) >> 2);
    return ((x & 0x55555555U) << 1) | ((x & 0xaaaaaaaaU) >> 1);
}

/// A permutation in which a bit is changed only by those below it (Laine & Karras 2011, "Stratified
/// Sampling for Stochastic Transparency"); constants after Vegdahl 2021, "Building a Better LK
/// Hash".
std::uint32_t low_to_high_permutation(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return x;
}

/// Nested uniform scrambling: which half an interval's points go to depends only on the interval.
std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    return reverse_bits(low_to_high_permutation(reverse_bits(x), seed));
}

/// The second Sobol' dimension: Pascal's triangle modulo 2 as generator matrix.
std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 1U << 31; index != 0; index >>= 1, column ^= column >> 1) {
        if (index & 1U) result ^= column;
    }
    return result;
}

/// Maps to [0, 1): all 32 bits fit a double.
double unit_interval(std::uint32_t x) {
    return x * 0x1p-32;
}

}  // namespace

std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
    // Finalizer of MurmurHash3 (Appleby) over both words; the multipliers are odd, so it is a
    // bijection of the 64 bits before they are folded.
    std::uint64_t h = (static_cast<std::uint64_t>(a) << 32 | b) + 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdULL;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return static_cast<std::uint32_t>(h ^ (h >> 33));
}

Vec2 scrambled_sobol(std::uint32_t index, std::uint32_t seed) {
    const std::uint32_t shuffled = owen_scramble(index, hash(seed, 0));
    const std::uint32_t x = owen_scramble(reverse_bits(shuffled), hash(seed, 1));
    const std::uint32_t y = owen_scramble(sobol_second(shuffled), hash(seed, 2));
    return {unit_interval(x), unit_interval(y)};
}

Vec2 uniform_random(std::uint32_t index, std::uint32_t seed) {
    const std::uint32_t name = hash(seed, index);
    return {unit_interval(hash(name, 0)), unit_interval(hash(name, 1))};
}

}  // namespace etalon
