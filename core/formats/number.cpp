#include "core/formats/number.h"

#include <limits>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/formats/number.cpp"
#include <hwy/foreach_target.h>

#include "core/formats/short_number-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

ScannedNumber scan_double(const char* first, const char* last, double& value) {
    return scan(first, last, value);
}

ScannedNumber scan_float(const char* first, const char* last, float& value) {
    return scan(first, last, value);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

namespace {

/// The sign has been read already.
ScannedNumber scan_long_integer(const char* p, const char* last, bool negative,
                                std::int64_t& value) {
    const char* const digits = p;
    while (p != last && *p == '0') ++p;
    const char* const significant = p;
    std::uint64_t number = 0;
    for (; p != last; ++p) {
        const unsigned digit = static_cast<unsigned char>(*p) - unsigned{'0'};
        if (digit > 9) break;
        number = number * 10 + digit;
    }
    constexpr std::ptrdiff_t most_digits = 19;  // 10^19 < 2^64
    if (p == digits) return {p, NumberStatus::malformed};
    if (p - significant > most_digits || number > std::numeric_limits<std::int64_t>::max()) {
        return {p, NumberStatus::out_of_range};
    }
    value = static_cast<std::int64_t>(number);
    if (negative) value = -value;
    return {p, NumberStatus::ok};
}

/// Makes Highway choose the function now instead of at the first call, so that the choice can be
/// kept: asking its library for every number would show in the time of reading.
void choose_target() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

HWY_EXPORT(scan_double);
HWY_EXPORT(scan_float);

ScannedNumber scan_number(const char* first, const char* last, double& value) {
    static const auto scan = (choose_target(), &HWY_DYNAMIC_DISPATCH(scan_double));
    return scan(first, last, value);
}

ScannedNumber scan_number(const char* first, const char* last, float& value) {
    static const auto scan = (choose_target(), &HWY_DYNAMIC_DISPATCH(scan_float));
    return scan(first, last, value);
}

ScannedNumber scan_number(const char* first, const char* last, std::int64_t& value) {
    const char* p = first;
    const bool negative = p != last && *p == '-';
    p += negative || (p != last && *p == '+');
    if (last - p >= 8) {
        const EightChars chars = load_eight(p);
        const int count = count_digits(chars);
        if (count > 0 && count < 8) {
            const std::int64_t size = value_of_digits(chars, count);
            value = negative ? -size : size;
            return {p + count, NumberStatus::ok};
        }
    }
    return scan_long_integer(p, last, negative, value);
}

}  // namespace etalon
#endif
