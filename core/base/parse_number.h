#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace etalon {

/// Returns the number, in C's notation, that is all of the text; nothing if it is anything else, or
/// out of the range of T.
template <class T>
std::optional<T> parse_number(std::string_view text) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

}  // namespace etalon
