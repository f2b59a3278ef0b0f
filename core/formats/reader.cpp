#include "core/formats/reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace etalon {
namespace {

bool is_infinity_or_nan(std::string_view word) {
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
    std::string lower(word.substr(0, std::string_view("infinity").size() + 1));
    for (char& c : lower) c = static_cast<char>(c | 0x20);
    return lower == "nan" || lower == "inf" || lower == "infinity";
}

}  // namespace

std::string_view Reader::begin() {
    start_ = tokens_.offset();
    return keyword_ = tokens_.next();
}

bool Reader::at_keyword() const {
    return std::ranges::find(keywords_, tokens_.peek()) != keywords_.end();
}

std::size_t Reader::skip_to_keyword() {
    std::size_t words = 0;
    for (; !tokens_.at_end() && !at_keyword(); ++words) tokens_.next();
    return words;
}

Vec3 Reader::vector(std::string_view what) {
    const double x = number(what), y = number(what), z = number(what);
    return {x, y, z};
}

Color Reader::color(std::string_view what) {
    Color color(0.0F);
    for (int k = 0; k < 3; ++k) {
        const std::size_t offset = tokens_.offset();
        const double value = number(what);
        if (std::abs(value) > std::numeric_limits<float>::max()) {
            fail_at(offset, "range", "the {} of '{}' is too large for a colour", what, keyword_);
        }
        color[k] = ok_ ? static_cast<float>(value) : 0;
    }
    return color;
}

std::string_view Reader::word(std::string_view what) {
    if (ok_ && tokens_.at_end()) reject("a word", what, NumberStatus::malformed);
    return ok_ ? tokens_.next() : std::string_view();
}

std::size_t Reader::room_for(std::size_t numbers) const {
    return (tokens_.remaining() + 1) / (2 * numbers);  // a digit and a blank each, save the last
}

std::size_t Reader::count(std::string_view what, std::size_t numbers) {
    const std::size_t offset = tokens_.offset();
    const std::int64_t n = integer(what);
    if (!ok_) return 0;
    const std::size_t room = room_for(numbers);
    if (n >= 0 && static_cast<std::size_t>(n) <= room) return static_cast<std::size_t>(n);
    if (n < 0) {
        fail_at(offset, "count", "the {} of '{}' is negative", what, keyword_);
    } else {
        fail_at(offset, "count", "the {} of '{}' is {}, but the rest of the file holds at most {}",
                what, keyword_, n, room);
    }
    return 0;
}

void Reader::reject(std::string_view expected, std::string_view what, NumberStatus status) {
    const std::string_view found = tokens_.peek();
    std::string_view kind = "syntax", because;
    if (status == NumberStatus::out_of_range) kind = "range", because = ", which is too large";
    if (is_infinity_or_nan(found)) kind = "range", because = ", which is not finite";
    fail_at(tokens_.offset(), kind, "expected {} for the {} of '{}', found {}{}", expected, what,
            keyword_, found.empty() ? std::string(end_) : in_quotes(found), because);
}

}  // namespace etalon
