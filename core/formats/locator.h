#pragma once

#include <cstddef>
#include <string_view>

namespace etalon {

/// A place in a text, counted from 1, with columns in bytes.
struct TextPosition {
    int line, column;
};

/// Converts byte offsets to lines and columns. It remembers the last place and counts from there,
/// so that queries in increasing order cost one pass over the text. Lines end with LF or CRLF, or,
/// in a text without any LF, with CR.
class Locator {
  public:
    explicit Locator(std::string_view text)
        : text_(text), line_end_(text.find('\n') == text.npos ? '\r' : '\n') {}

    /// Returns the position of `offset`, which may be the end of the text.
    TextPosition locate(std::size_t offset);

  private:
    void advance(std::size_t offset);
    void jump(std::size_t offset);

    std::string_view text_;
    char line_end_;
    std::size_t offset_ = 0;      // the last queried place,
    std::size_t line_start_ = 0;  // where its line starts
    std::size_t line_ = 1;        // and the number of that line
};

}  // namespace etalon
