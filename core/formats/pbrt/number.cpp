#include "core/formats/pbrt/number.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/formats/number.h"

namespace etalon::pbrt {
namespace {

struct Special {
    std::string_view word;
    double value;
};

constexpr std::array specials = {
    Special{"infinity", std::numeric_limits<double>::infinity()},
    Special{"inf", std::numeric_limits<double>::infinity()},
    Special{"nan", std::numeric_limits<double>::quiet_NaN()},
};

/// Returns whether `text` starts with `word`, which is in lower case, in any case.
bool starts_with(std::string_view text, std::string_view word) {
    if (text.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if ((text[i] | 0x20) != word[i]) return false;
    }
    return true;
}

std::optional<LooseNumber> read_special(std::string_view word) {
    const bool has_sign = !word.empty() && (word[0] == '-' || word[0] == '+');
    const double sign = has_sign && word[0] == '-' ? -1 : 1;
    if (has_sign) word.remove_prefix(1);
    for (const Special& s : specials) {
        if (starts_with(word, s.word))
            return LooseNumber{sign * s.value, word.substr(s.word.size())};
    }
    return std::nullopt;
}

}  // namespace

std::optional<LooseNumber> read_number(std::string_view word) {
    const char* const last = word.data() + word.size();
    double value = 0;
    const ScannedNumber scanned = scan_number(word.data(), last, value);
    if (scanned.status == NumberStatus::malformed) return read_special(word);
    if (scanned.status == NumberStatus::out_of_range) {
        const bool negative = word[0] == '-';
        value = negative ? -std::numeric_limits<double>::infinity()
                         : std::numeric_limits<double>::infinity();
        return LooseNumber{value, {}};
    }
    return LooseNumber{value, word.substr(static_cast<std::size_t>(scanned.end - word.data()))};
}

// Rounding twice is wrong only where the double lies halfway between two floats, which have 29
// bits less, or where floats are denormal.
float to_float(double nearest, const char* first, const char* last) {
    constexpr std::uint64_t dropped = (std::uint64_t{1} << 29) - 1;
    constexpr std::uint64_t halfway = std::uint64_t{1} << 28;
    const bool is_halfway = (std::bit_cast<std::uint64_t>(nearest) & dropped) == halfway;
    const bool is_tiny = std::abs(nearest) < std::numeric_limits<float>::min() && nearest != 0;
    auto value = static_cast<float>(nearest);
    if (is_halfway || is_tiny) {
        if (first != last && *first == '+') ++first;
        float exact = 0;
        if (std::from_chars(first, last, exact).ec == std::errc()) value = exact;
    }
    return value;
}

}  // namespace etalon::pbrt
