#include "core/formats/locator.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

namespace etalon {
namespace {

int saturated(std::size_t n) {
    return static_cast<int>(std::min<std::size_t>(n, std::numeric_limits<int>::max()));
}

/// Counts in bytes before they could overflow, so that one instruction counts sixteen characters.
std::size_t count_of(char c, std::string_view text) {
    constexpr std::size_t lanes = 32, most = 255;
    std::size_t sum = 0;
    while (text.size() >= lanes) {
        const std::size_t rows = std::min(text.size() / lanes, most);
        std::array<std::uint8_t, lanes> counts{};
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t k = 0; k < lanes; ++k) {
                counts[k] = static_cast<std::uint8_t>(counts[k] + (text[row * lanes + k] == c));
            }
        }
        for (const std::uint8_t count : counts) sum += count;
        text.remove_prefix(rows * lanes);
    }
    return sum + static_cast<std::size_t>(std::count(text.begin(), text.end(), c));
}

}  // namespace

/// Looks for one line end after the other, of which there are few between two statements.
void Locator::advance(std::size_t offset) {
    const char* const text = text_.data();
    while (const void* const found = std::memchr(text + offset_, line_end_, offset - offset_)) {
        offset_ = line_start_ =
            static_cast<std::size_t>(static_cast<const char*>(found) - text) + 1;
        ++line_;
    }
    offset_ = offset;
}

TextPosition Locator::locate(std::size_t offset) {
    constexpr std::size_t few = 512;
    if (offset >= offset_ && offset - offset_ < few) {
        advance(offset);
    } else {
        jump(offset);
    }
    return {saturated(line_), saturated(offset - line_start_ + 1)};
}

/// Counts all line ends in between.
void Locator::jump(std::size_t offset) {
    const bool forward = offset >= offset_;
    const std::size_t low = forward ? offset_ : offset;
    const std::string_view between = text_.substr(low, (forward ? offset : offset_) - low);
    if (const std::size_t crossed = count_of(line_end_, between); crossed > 0) {
        line_ = forward ? line_ + crossed : line_ - crossed;
        line_start_ =
            text_.substr(0, offset).rfind(line_end_) + 1;  // npos + 1 is 0: the first line
    }
    offset_ = offset;
}

}  // namespace etalon
