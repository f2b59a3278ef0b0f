#include "core/formats/tokenizer.h"

#include <algorithm>

#include "core/formats/byte_order_mark.h"

namespace etalon {
namespace {

const char* end_of_line(const char* p, const char* last) {
    return std::find_if(p, last, [](char c) { return c == '\n' || c == '\r'; });
}

}  // namespace

Tokenizer::Tokenizer(std::string_view text)
    : first_(text.data()), cursor_(first_), last_(first_ + text.size()) {
    move_to(first_ + byte_order_mark_size(text));
}

bool Tokenizer::at_number() const {
    const std::string_view word = peek();
    const std::size_t first = word.find_first_not_of("+-.");
    return first <= 2 && word[first] >= '0' && word[first] <= '9';
}

std::string_view Tokenizer::peek() const {
    const char* const end = std::find_if(cursor_, last_, ends_word);
    return {cursor_, static_cast<std::size_t>(end - cursor_)};
}

std::string_view Tokenizer::next() {
    const std::string_view word = peek();
    move_to(word.data() + word.size());
    return word;
}

std::string_view Tokenizer::next_with_string() {
    const std::string_view word = peek();
    const std::size_t open = word.find('"');
    if (open == word.npos) return next();
    const char* const inside = word.data() + open + 1;
    const char* const line_end = end_of_line(inside, last_);
    const char* const close = std::find(inside, line_end, '"');
    if (close == line_end) return next();
    const char* const start = cursor_;
    move_to(close + 1);
    return {start, close + 1};
}

Tokenizer Tokenizer::take_line() {
    Tokenizer line = *this;
    line.last_ = end_of_line(cursor_, last_);
    move_to(line.last_);
    return line;
}

void Tokenizer::skip_comments() {
    while (cursor_ != last_ && *cursor_ == '#') {
        cursor_ = end_of_line(cursor_, last_);
        while (cursor_ != last_ && is_blank(*cursor_)) ++cursor_;
    }
}

}  // namespace etalon
