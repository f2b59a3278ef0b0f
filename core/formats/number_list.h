// Long lists of numbers, as meshes in scene files are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace etalon {

/// Reads numbers with blanks and comments, from '#' to the end of the line, between them, until
/// `values` are full or the text goes on with anything else: its end, a bracket or a quotation
/// mark, or a word that is no number as a whole, or none of the type. Moves p there. Returns how
/// many were read. T is float, double or std::int32_t, to which what has a point is cut off.
template <class T>
std::size_t read_numbers(const char*& p, const char* last, std::span<T> values);

/// Appends all numbers up to such a place to `values`, a vector of T. For a long list room is made
/// as if it went on to the next bracket with numbers as long as the first.
template <class Vector>
void read_numbers(const char*& p, const char* last, Vector& values) {
    using T = typename Vector::value_type;
    constexpr std::size_t most_at_once = 1 << 14;  // they stay in the nearest cache
    const char* const first = p;
    const std::size_t before = values.size();
    std::size_t count = before;
    while (true) {
        const std::size_t room = (static_cast<std::size_t>(last - p) + 1) / 2;  // a digit, a blank
        values.resize(count + std::min(most_at_once, room));
        count += read_numbers(p, last, std::span<T>(values).subspan(count));
        if (count < values.size() || p == last) break;
        if (values.capacity() >= count + most_at_once) continue;
        const void* const bracket = std::memchr(p, ']', static_cast<std::size_t>(last - p));
        const char* const end = bracket ? static_cast<const char*>(bracket) : last;
        const double numbers_a_byte =
            static_cast<double>(count - before) / static_cast<double>(p - first);
        const auto to_come =
            static_cast<std::size_t>(1.02 * numbers_a_byte * static_cast<double>(end - p));
        values.reserve(count + std::min(to_come, 7 * count));  // the first may be short
    }
    values.resize(count);
}

}  // namespace etalon
