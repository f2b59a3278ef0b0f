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

/// Applies the second generator matrix of Sobol' with its rows reversed. The matrix is Pascal's
/// triangle modulo 2, in which C(k, j) is odd where all bits of j are bits of k (Lucas): bit j of
/// the result is the sum of the bits k above it, which five steps give, one for each bit of k.
std::uint32_t reversed_sobol_second(std::uint32_t index) {
    index ^= (index >> 16) & 0x0000ffffU;
    index ^= (index >> 8) & 0x00ff00ffU;
    index ^= (index >> 4) & 0x0f0f0f0fU;
    index ^= (index >> 2) & 0x33333333U;
    return index ^ ((index >> 1) & 0x55555555U);
}

/// Maps to [0, 1): all 32 bits fit a double.
double unit_interval(std::uint32_t x) {
    return x * 0x1p-32;
}

}  // namespace

/// A nested uniform scramble, by which half an interval's points go to depends on the interval
/// only, is low_to_high_permutation between two reversals of bits. The first of each coordinate
/// undoes the one that the van der Corput sequence begins with, so neither is done.
Vec2 ScrambledSobol::operator()(std::uint32_t index) const {
    const std::uint32_t shuffled =
        reverse_bits(low_to_high_permutation(reverse_bits(index), order_));
    const std::uint32_t x = reverse_bits(low_to_high_permutation(shuffled, x_));
    const std::uint32_t y =
        reverse_bits(low_to_high_permutation(reversed_sobol_second(shuffled), y_));
    return {unit_interval(x), unit_interval(y)};
}

Vec2 uniform_random(std::uint32_t index, std::uint32_t seed) {
    const std::uint32_t name = hash(seed, index);
    return {unit_interval(hash(name, 0)), unit_interval(hash(name, 1))};
}

}  // namespace etalon
