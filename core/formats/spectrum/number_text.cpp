#include "core/formats/spectrum/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/formats/tokenizer.h"
#include "core/numerics/vec.h"

namespace etalon {
namespace {

bool begins_number(char c) {
    return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-';
}

/// Reads the numbers of a word, which commas and the like may separate.
void read_word(std::string_view word, std::size_t offset, DiagnosticLog& log,
               std::vector<PlacedNumber>& numbers) {
    const char* const last = word.data() + word.size();
    bool said = false;
    for (const char* p = word.data(); p != last;) {
        const std::size_t place = offset + static_cast<std::size_t>(p - word.data());
        double value = 0;
        const ScannedNumber scanned = scan_number(p, last, value);
        if (scanned.status == NumberStatus::malformed) {
            if (!said)
                log.warn(place, "syntax", "passed over what is not a number in {}",
                         in_quotes(word));
            said = true;
            p = std::find_if(p + 1, last, begins_number);
        } else {
            const bool usable = std::abs(value) <= std::numeric_limits<float>::max() &&
                                scanned.status == NumberStatus::ok;
            numbers.push_back({usable ? value : nan_value, place});
            p = scanned.end;
        }
    }
}

}  // namespace

std::vector<PlacedNumber> read_number_text(std::string_view text, DiagnosticLog& log) {
    std::vector<PlacedNumber> numbers;
    for (Tokenizer words(text); !words.at_end();) {
        const std::size_t offset = words.offset();
        read_word(words.next(), offset, log, numbers);
    }
    return numbers;
}

}  // namespace etalon
