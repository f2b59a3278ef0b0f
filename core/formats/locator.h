#pragma once

#include <cstddef>
#include <string_view>

namespace etalon {

/// A place in a text as people count: from 1, columns in bytes.
struct TextPosition {
    int line, column;
};

/// Turns byte offsets into lines and columns. It remembers the place it was asked for last and
/// counts from there, so that many questions in order cost one pass over the text.
class Locator {
  public:
    explicit Locator(std::string_view text) : text_(text) {}

    /// Returns the position of `offset`, which may be the end of the text.
    TextPosition locate(std::size_t offset);

  private:
    std::string_view text_;
    std::size_t offset_ = 0;      // the last place asked for,
    std::size_t line_start_ = 0;  // where its line starts
    std::size_t line_ = 1;        // and the number of that line
};

}  // namespace etalon
