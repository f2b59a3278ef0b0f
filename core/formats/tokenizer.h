// The words of a scene file: anything between blanks, tabs and line ends (LF, CRLF or CR), with
// comments from '#' to the end of the line, anywhere.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/formats/number.h"

namespace etalon {

/// A cursor over a text, which must outlive it. It is at the start of a word or at the end. Nothing
/// is copied; to look further ahead, copy the tokenizer.
class Tokenizer {
  public:
    explicit Tokenizer(std::string_view text);

    bool at_end() const { return cursor_ == last_; }

    /// Returns whether the next word starts like a number. It need not be well-formed.
    bool at_number() const;

    /// Returns the next word; empty at the end.
    std::string_view peek() const;
    std::string_view next();

    /// Returns the next word, or all words up to the quote that closes a string which starts in it.
    std::string_view next_with_string();

    /// Takes the rest of the line that the next word is on, and moves past it: for formats where
    /// the line ends a statement.
    Tokenizer take_line();

    /// Reads the next word as a number, and moves on only if the whole word is one.
    template <class T>
    NumberStatus number(T& value) {
        const ScannedNumber scanned = scan_number(cursor_, last_, value);
        const bool whole = scanned.end == last_ || ends_word(*scanned.end);
        if (!whole) return NumberStatus::malformed;
        if (scanned.status == NumberStatus::ok) move_to(scanned.end);
        return scanned.status;
    }

    /// Returns the number of bytes before the next word, or of those from it on.
    std::size_t offset() const { return static_cast<std::size_t>(cursor_ - first_); }
    std::size_t remaining() const { return static_cast<std::size_t>(last_ - cursor_); }

  private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    static bool ends_word(char c) { return is_blank(c) || c == '#'; }

    /// Moves to the first word at or after `p`.
    void move_to(const char* p) {
        while (p != last_ && is_blank(*p)) ++p;
        cursor_ = p;
        if (p != last_ && *p == '#') skip_comments();
    }
    void skip_comments();

    const char *first_, *cursor_, *last_;
};

}  // namespace etalon
