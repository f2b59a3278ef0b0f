#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace etalon {

/// Parses JSON of files that anyone may have written, without the values that are nested deeper
/// than any of ours: the library compares, copies and prints values by recursion, for which the
/// stack may be too small. Malformed text gives a discarded value.
inline nlohmann::ordered_json parse_shallow_json(std::string_view text) {
    constexpr int deepest = 8;
    const auto is_kept = [](int depth, nlohmann::ordered_json::parse_event_t,
                            nlohmann::ordered_json&) { return depth < deepest; };
    return nlohmann::ordered_json::parse(text, is_kept, false);
}

/// Returns a number of a text that anyone may have written. Throws Json::out_of_range if it is not
/// a whole number of type T: the library's own conversion is undefined then.
template <class T>
T whole_number(const nlohmann::ordered_json& json) {
    if (json.is_number_unsigned() && std::in_range<T>(json.get<std::uint64_t>())) return json;
    if (json.is_number_integer() && !json.is_number_unsigned() &&
        std::in_range<T>(json.get<std::int64_t>())) {
        return json;
    }
    throw nlohmann::ordered_json::out_of_range::create(406, "not such a whole number", &json);
}

}  // namespace etalon
