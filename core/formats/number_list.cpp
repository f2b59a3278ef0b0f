#include "core/formats/number_list.h"

#include <algorithm>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/formats/number_list.cpp"
#include <hwy/foreach_target.h>

#include "core/formats/short_number-inl.h"

#ifndef ETALON_NUMBER_LIST_ONCE
#define ETALON_NUMBER_LIST_ONCE
namespace etalon {

inline bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

inline bool ends_number(char c) {
    return is_blank(c) || c == ']' || c == '[' || c == '"';
}

/// Moves to the next word or bracket.
inline void skip_blanks(const char*& p, const char* last) {
    while (p != last) {
        if (*p == '#') {
            p = std::find_if(p, last, [](char c) { return c == '\n' || c == '\r'; });
        } else if (is_blank(*p)) {
            ++p;
        } else {
            return;
        }
    }
}

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

HWY_INLINE ScannedNumber scan(const char* first, const char* last, std::int32_t& value) {
    double number = 0;
    const ScannedNumber scanned = scan(first, last, number);
    if (!(number > -0x1p31 - 1 && number < 0x1p31))
        return {scanned.end, NumberStatus::out_of_range};
    value = static_cast<std::int32_t>(number);
    return scanned;
}

/// Reads a single digit without looking at what else a number may be: most matrices have many.
HWY_INLINE ScannedNumber scan_element(const char* first, const char* last, double& value) {
    if (last - first > 1 && first[1] == ' ' && *first >= '0' && *first <= '9') {
        value = *first - '0';
        return {first + 1, NumberStatus::ok};
    }
    return scan(first, last, value);
}
template <class T>
HWY_INLINE ScannedNumber scan_element(const char* first, const char* last, T& value) {
    return scan(first, last, value);
}

template <class T>
HWY_INLINE std::size_t read_list(const char*& p, const char* last, T* values, std::size_t most) {
    const char* next = p;
    std::size_t count = 0;
    skip_blanks(next, last);
    for (; count < most && next != last; ++count) {
        const ScannedNumber scanned = scan_element(next, last, values[count]);
        if (scanned.status != NumberStatus::ok) break;
        if (scanned.end != last && !ends_number(*scanned.end)) break;
        next = scanned.end;
        if (next != last && is_blank(*next)) ++next;
        if (next != last && *next <= '#')
            skip_blanks(next, last);  // blanks are below, numbers above
    }
    p = next;
    return count;
}

std::size_t read_floats(const char*& p, const char* last, float* values, std::size_t most) {
    return read_list(p, last, values, most);
}

std::size_t read_doubles(const char*& p, const char* last, double* values, std::size_t most) {
    return read_list(p, last, values, most);
}

std::size_t read_integers(const char*& p, const char* last, std::int32_t* values,
                          std::size_t most) {
    return read_list(p, last, values, most);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(read_floats);
HWY_EXPORT(read_doubles);
HWY_EXPORT(read_integers);

template <>
std::size_t read_numbers(const char*& p, const char* last, std::span<float> values) {
    return HWY_DYNAMIC_DISPATCH(read_floats)(p, last, values.data(), values.size());
}

template <>
std::size_t read_numbers(const char*& p, const char* last, std::span<double> values) {
    return HWY_DYNAMIC_DISPATCH(read_doubles)(p, last, values.data(), values.size());
}

template <>
std::size_t read_numbers(const char*& p, const char* last, std::span<std::int32_t> values) {
    return HWY_DYNAMIC_DISPATCH(read_integers)(p, last, values.data(), values.size());
}

}  // namespace etalon
#endif
