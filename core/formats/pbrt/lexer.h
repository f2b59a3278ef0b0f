#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/byte_order_mark.h"

namespace etalon::pbrt {

enum class TokenKind : std::uint8_t {
    end,
    word,  ///< directive or number
    string,
    open,
    close,
    malformed,  ///< not a valid string; the text says why
};

struct Token {
    TokenKind kind;
    std::string_view text;  ///< for a string, its contents with escapes resolved
    std::size_t offset;     ///< number of bytes before it
};

/// Returns a token as it appears in messages: "'x'", "the end of the file".
std::string describe(const Token& token);

/// Tokens of one text, which must outlive the lexer. A token is valid until the next call.
class Lexer {
  public:
    explicit Lexer(std::string_view text)
        : first_(text.data()),
          cursor_(first_ + byte_order_mark_size(text)),
          last_(first_ + text.size()) {}

    Token next();

    /// Appends the numbers that follow, up to the first token that is not a plain finite number, or
    /// not an integer of 32 bits once its fraction is cut off.
    void take_numbers(std::vector<float>& values);
    void take_numbers(std::vector<std::int32_t>& values);

    /// Fills `values` with the numbers that follow, up to such a token. Returns how many there
    /// were.
    std::size_t take_numbers(std::span<double> values);

  private:
    std::size_t offset() const { return static_cast<std::size_t>(cursor_ - first_); }
    void skip_blanks();
    Token string();
    Token malformed(const char* start, std::string_view why);

    const char *first_, *cursor_, *last_;
    std::string unescaped_;  ///< text of the last string with escapes
};

}  // namespace etalon::pbrt
