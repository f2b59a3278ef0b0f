#include "tests/fuzz/text_mutator.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "core/numerics/random.h"

namespace etalon::fuzz {
namespace {

constexpr std::array<std::string_view, 34> numbers = {"0",
                                                      "-0",
                                                      "1",
                                                      "-1",
                                                      "2",
                                                      "3",
                                                      "0.5",
                                                      "-1e-3",
                                                      "1e308",
                                                      "1e-308",
                                                      "-1e308",
                                                      "1e309",
                                                      "5e-324",
                                                      "1e38",
                                                      "1e-38",
                                                      "1e-46",
                                                      "3.4e38",
                                                      "1e20",
                                                      "1e-20",
                                                      "255",
                                                      "256",
                                                      "65535",
                                                      "65536",
                                                      "65537",
                                                      "2147483647",
                                                      "-2147483648",
                                                      "2147483648",
                                                      "4294967295",
                                                      "4294967296",
                                                      "9223372036854775807",
                                                      "1.0000000000000002",
                                                      "nan",
                                                      "inf",
                                                      "0x1p3"};

/// A range of characters in a text.
struct Piece {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
};

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::vector<Piece> words_of(const std::string& text) {
    std::vector<Piece> list;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t begin = i;
        while (i < text.size() && !is_space(text[i])) ++i;
        if (i > begin) list.push_back({begin, i});
        while (i < text.size() && is_space(text[i])) ++i;
    }
    return list;
}

std::vector<Piece> lines_of(const std::string& text) {
    std::vector<Piece> list;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find('\n', i), text.size() - 1) + 1;
        list.push_back({i, end});
        i = end;
    }
    return list;
}

/// Changes one text.
class Mutation {
  public:
    Mutation(const std::string& text, const std::vector<std::string>& words, Random& random)
        : text_(text), words_(words), random_(random) {}

    std::string changed() {
        const std::vector<Piece> pieces = words_of(text_);
        if (pieces.empty()) return inserted(0);
        const Piece word = pieces[random_.index(pieces.size())];
        switch (random_.index(9)) {
            case 0:
                return replaced(number_among(pieces), numbers[random_.index(numbers.size())]);
            case 1:
                return replaced(word, any_word());
            case 2:
                return replaced(word, "");
            case 3:
                return inserted(word.begin);
            case 4:
                return replaced(number_among(pieces), next_number(number_among(pieces)));
            case 5:
                return swapped(word, pieces[random_.index(pieces.size())]);
            case 6:
                return without_line();
            case 7:
                return with_line_again();
            default:
                return swapped(any_line(), any_line());
        }
    }

  private:
    std::string_view at(Piece p) const { return std::string_view(text_).substr(p.begin, p.size()); }

    std::string replaced(Piece p, std::string_view by) const {
        return text_.substr(0, p.begin) + std::string(by) + text_.substr(p.end);
    }

    std::string_view any_word() {
        return words_.empty() ? numbers[random_.index(numbers.size())]
                              : std::string_view(words_[random_.index(words_.size())]);
    }

    /// Returns the text with a statement, a word and a few numbers, inserted at `place`.
    std::string inserted(std::size_t place) {
        std::string statement(any_word());
        for (std::uint32_t i = random_.index(8); i > 0; --i) {
            statement += ' ' + std::string(numbers[random_.index(numbers.size())]);
        }
        return replaced({place, place}, statement + (random_.one_in(2) ? "\n" : " "));
    }

    /// Returns the first number from a random word on, or that word if none follows.
    Piece number_among(const std::vector<Piece>& pieces) {
        const std::size_t start = random_.index(pieces.size());
        for (std::size_t i = start; i < pieces.size(); ++i) {
            const char first = at(pieces[i]).front();
            if (first == '-' || first == '.' || (first >= '0' && first <= '9')) return pieces[i];
        }
        return pieces[start];
    }

    /// Returns a number that differs from an integer by one or a factor of two, or its negative.
    std::string next_number(Piece p) {
        std::int32_t count = 0;
        const std::string_view word = at(p);
        std::from_chars(word.data(), word.data() + word.size(), count);
        const std::array<std::int64_t, 5> list = {count + std::int64_t{1}, count - std::int64_t{1},
                                                  std::int64_t{2} * count, count / 2,
                                                  -std::int64_t{count}};
        return std::to_string(list[random_.index(list.size())]);
    }

    std::string swapped(Piece a, Piece b) const {
        if (a.begin > b.begin) std::swap(a, b);
        if (a.end > b.begin) return text_;
        return text_.substr(0, a.begin) + std::string(at(b)) +
               text_.substr(a.end, b.begin - a.end) + std::string(at(a)) + text_.substr(b.end);
    }

    Piece any_line() {
        const std::vector<Piece> lines = lines_of(text_);
        return lines[random_.index(lines.size())];
    }

    std::string without_line() { return replaced(any_line(), ""); }

    std::string with_line_again() {
        const std::string line(at(any_line()));
        const std::size_t place = any_line().begin;
        return replaced({place, place}, line);
    }

    const std::string& text_;
    const std::vector<std::string>& words_;
    Random& random_;
};

}  // namespace

std::string mutated_text(const std::string& text, const std::vector<std::string>& words,
                         unsigned seed) {
    Random random(seed);
    std::string result = text;
    for (std::uint32_t i = random.index(4) + 1; i > 0; --i) {
        result = Mutation(result, words, random).changed();
    }
    return result;
}

}  // namespace etalon::fuzz
