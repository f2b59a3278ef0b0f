#include "core/color/decode_srgb.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/color/srgb.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/color/decode_srgb.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/float_power_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Decodes as many values as vectors have lanes. Returns a mask of those that are uncertain.
HWY_INLINE std::uint32_t decode_lanes(const float* from, float* to) {
    const DoubleTag tag;
    const hn::Rebind<float, DoubleTag> floats;
    const Doubles x = hn::PromoteTo(tag, hn::LoadU(floats, from));
    const Doubles most_linear = broadcast(0.04045);
    const DoubleMask is_linear = x <= most_linear;
    const FloatPowers powers = float_powers((x + broadcast(0.055)) / broadcast(1.055), 2.4);
    const Doubles decoded = hn::IfThenElse(is_linear, x / broadcast(12.92), powers.values);
    hn::StoreU(hn::DemoteTo(floats, decoded), floats, to);
    // What is not finite, Highway demotes as each instruction set does.
    const DoubleMask is_certain = hn::Or(hn::And(is_linear, x > broadcast(-infinity)),
                                         hn::And(powers.certain, x > most_linear));
    std::uint8_t certain = 0;
    hn::StoreMaskBits(tag, is_certain, &certain);
    return ~std::uint32_t{certain} & ((1U << hn::Lanes(tag)) - 1);
}

/// Decodes as many values in place.
HWY_INLINE void decode_in_place(float* values) {
    float decoded[most_doubles];
    std::uint32_t left = decode_lanes(values, decoded);
    for (; left != 0; left &= left - 1) {
        const int k = std::countr_zero(left);
        decoded[k] = static_cast<float>(srgb_decoded(values[k]));
    }
    std::copy_n(decoded, hn::Lanes(DoubleTag()), values);
}

void decode(float* values, std::size_t count) {
    const std::size_t lanes = hn::Lanes(DoubleTag());
    for (; count >= lanes; values += lanes, count -= lanes) decode_in_place(values);
    float padded[most_doubles] = {};
    std::copy_n(values, count, padded);
    decode_in_place(padded);
    std::copy_n(padded, count, values);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(decode);

void decode_srgb(std::span<float> values) {
    HWY_DYNAMIC_DISPATCH(decode)(values.data(), values.size());
}

}  // namespace etalon
#endif
