#include "core/formats/nearest_name.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace etalon {
namespace {

constexpr std::size_t longest = 32;

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Returns the optimal string alignment distance (Damerau 1964); neither word is longer than
/// `longest`.
std::size_t typing_errors(std::string_view a, std::string_view b) {
    using Row = std::array<std::size_t, longest + 1>;
    Row before{}, above{}, row{};
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = above;
        above = row;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t exchange = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + exchange});
            const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                                 lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

/// Returns the letters of a word as bits; some share a bit.
std::uint64_t letters_of(std::string_view word) {
    std::uint64_t letters = 0;
    for (const char c : word) letters |= std::uint64_t{1} << (lower(c) & 63);
    return letters;
}

/// Returns a lower bound on the typing errors between words of these letters: an error adds at most
/// one letter that the other word lacks. It rules out most names.
std::size_t fewest_errors(std::uint64_t a, std::uint64_t b) {
    return static_cast<std::size_t>(std::max(std::popcount(a & ~b), std::popcount(b & ~a)));
}

/// Returns the number of letters of the common prefix.
std::size_t common_start(std::string_view a, std::string_view b) {
    std::size_t n = 0;
    while (n < a.size() && n < b.size() && lower(a[n]) == lower(b[n])) ++n;
    return n;
}

}  // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
    if (word.size() > longest) return {};
    const std::uint64_t letters = letters_of(word);
    std::string_view nearest;
    std::size_t fewest = longest, longest_start = 0;
    for (const std::string_view name : names) {
        if (name.size() > longest) continue;
        const auto [shorter, longer] = std::minmax({word.size(), name.size()});
        const std::size_t too_many = std::min({shorter / 3 + 2, shorter, fewest + 1});
        if (longer - shorter >= too_many) continue;  // each missing letter is an error
        if (fewest_errors(letters, letters_of(name)) >= too_many) continue;
        const std::size_t errors = typing_errors(word, name);
        const std::size_t start = common_start(word, name);
        if (errors < too_many && (errors < fewest || start > longest_start)) {
            nearest = name;
            fewest = errors;
            longest_start = start;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> names) {
    const std::string_view name = nearest_name(word, names);
    return name.empty() ? std::string() : "; did you mean '" + std::string(name) + "'?";
}

}  // namespace etalon
