#include "core/formats/statements.h"

#include "core/formats/nearest_name.h"

namespace etalon {

void skip_stray_words(Reader& in, std::string_view before,
                      std::span<const std::string_view> suggestions) {
    const bool number = in.tokens().at_number();
    const std::string_view word = in.begin();
    const std::size_t more = in.skip_to_keyword();
    const std::string end = more == 0 ? "" : fmt::format(" (words skipped: {})", more + 1);
    if (number && !before.empty()) {
        in.warn("stray", "expected a keyword after '{}', found {}{}", before, in_quotes(word), end);
    } else if (number) {
        in.warn("stray", "expected a keyword, found {}{}", in_quotes(word), end);
    } else {
        in.warn("keyword", "unknown keyword {}{}{}", in_quotes(word), end,
                did_you_mean(word, suggestions));
    }
}

}  // namespace etalon
