#pragma once

#include <cstddef>
#include <string_view>

namespace etalon {

/// Returns the size of the byte order mark with which some editors begin a text in UTF-8; 0 if
/// there is none.
inline std::size_t byte_order_mark_size(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? mark.size() : 0;
}

}  // namespace etalon
