#include "core/sampling/sobol.h"

#include "core/numerics/instruction_sets.h"
#include "core/sampling/sobol-inl.h"

namespace etalon {
namespace {

/// Maps to [0, 1); all 32 bits fit a double.
double unit_interval(std::uint32_t x) {
    return x * 0x1p-32;
}

}  // namespace

Vec2 ScrambledSobol::operator()(std::uint32_t index) const {
    const auto [x, y] = HWY_NAMESPACE::scrambled_point(index, order_, x_, y_);
    return {unit_interval(x), unit_interval(y)};
}

Vec2 uniform_random(std::uint32_t index, std::uint32_t seed) {
    const std::uint32_t name = hash(seed, index);
    return {unit_interval(hash(name, 0)), unit_interval(hash(name, 1))};
}

}  // namespace etalon
