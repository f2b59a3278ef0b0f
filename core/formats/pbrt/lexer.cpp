#include "core/formats/pbrt/lexer.h"

#include <algorithm>
#include <array>

#include "core/formats/diagnostic_log.h"
#include "core/formats/number_list.h"

namespace etalon::pbrt {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

bool ends_word(char c) {
    return is_blank(c) || c == '"' || c == '[' || c == ']';
}

struct Escape {
    char letter, meaning;
};

constexpr std::array escapes = {Escape{'b', '\b'},  Escape{'f', '\f'}, Escape{'n', '\n'},
                                Escape{'r', '\r'},  Escape{'t', '\t'}, Escape{'\\', '\\'},
                                Escape{'\'', '\''}, Escape{'"', '"'}};

/// Resolves the escapes of [first, last) into `text`; returns false for an unknown one.
bool unescape(const char* first, const char* last, std::string& text) {
    text.clear();
    for (const char* p = first; p != last; ++p) {
        if (*p != '\\') {
            text += *p;
            continue;
        }
        const auto escape = std::ranges::find(escapes, *++p, &Escape::letter);
        if (escape == escapes.end()) return false;
        text += escape->meaning;
    }
    return true;
}

}  // namespace

std::string describe(const Token& token) {
    if (token.kind == TokenKind::end) return "the end of the file";
    if (token.kind == TokenKind::malformed) return std::string(token.text);
    if (token.kind == TokenKind::string) return "the string " + in_quotes(token.text);
    return in_quotes(token.text);
}

void Lexer::skip_blanks() {
    while (true) {
        while (cursor_ != last_ && is_blank(*cursor_)) ++cursor_;
        if (cursor_ == last_ || *cursor_ != '#') return;
        while (cursor_ != last_ && *cursor_ != '\n' && *cursor_ != '\r') ++cursor_;
    }
}

Token Lexer::next() {
    skip_blanks();
    if (cursor_ == last_) return {TokenKind::end, {}, offset()};
    if (*cursor_ == '"') return string();
    const char* const start = cursor_++;
    const auto at = static_cast<std::size_t>(start - first_);
    if (*start == '[') return {TokenKind::open, {start, 1}, at};
    if (*start == ']') return {TokenKind::close, {start, 1}, at};
    cursor_ = std::find_if(cursor_, last_, ends_word);
    return {TokenKind::word, {start, static_cast<std::size_t>(cursor_ - start)}, at};
}

Token Lexer::string() {
    const char* const start = cursor_++;
    bool has_escapes = false;
    while (cursor_ != last_ && *cursor_ != '"' && *cursor_ != '\n') {
        if (*cursor_ == '\\') {
            has_escapes = true;
            if (++cursor_ == last_) break;
        }
        ++cursor_;
    }
    if (cursor_ == last_ || *cursor_ == '\n') {
        return malformed(start, "a string that does not end on its line");
    }
    const char* const end = cursor_++;
    const auto at = static_cast<std::size_t>(start - first_);
    if (!has_escapes) {
        return {TokenKind::string, {start + 1, static_cast<std::size_t>(end - start - 1)}, at};
    }
    if (!unescape(start + 1, end, unescaped_)) {
        return malformed(start,
                         "a string with an unknown escape; there are "
                         "\\b \\f \\n \\r \\t \\\\ \\' \\\"");
    }
    return {TokenKind::string, unescaped_, at};
}

Token Lexer::malformed(const char* start, std::string_view why) {
    return {TokenKind::malformed, why, static_cast<std::size_t>(start - first_)};
}

void Lexer::take_numbers(std::vector<float>& values) {
    read_numbers(cursor_, last_, values);
}

void Lexer::take_numbers(std::vector<std::int32_t>& values) {
    read_numbers(cursor_, last_, values);
}

std::size_t Lexer::take_numbers(std::span<double> values) {
    return read_numbers(cursor_, last_, values);
}

}  // namespace etalon::pbrt
