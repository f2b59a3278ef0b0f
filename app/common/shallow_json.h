#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

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

}  // namespace etalon
