#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// Returns a text as one line that cannot control a terminal, for a message: bytes of control
/// characters, also of line ends, become \x1b, as names from a file may forge other messages. A
/// text longer than about `longest` bytes is cut.
inline std::string printable(std::string_view text, std::size_t longest = std::string::npos) {
    constexpr const char* digits = "0123456789abcdef";
    const auto byte_at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    std::string shown;
    bool is_second = false;  // of two bytes of a control character
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned char byte = byte_at(i);
        const bool continues = (byte & 0xC0U) == 0x80;
        if (shown.size() >= longest && !continues) return shown + "...";
        const bool is_first =
            byte == 0xC2 && i + 1 < text.size() && byte_at(i + 1) >= 0x80 && byte_at(i + 1) < 0xA0;
        if (byte < ' ' || byte == 0x7F || is_first || is_second) {
            shown.append("\\x").append(1, digits[byte >> 4]).append(1, digits[byte & 15]);
        } else {
            shown += text[i];
        }
        is_second = is_first;
    }
    return shown;
}

}  // namespace etalon
