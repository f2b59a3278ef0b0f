// Statements of a scene file that is a stream of words: a keyword, then its values.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/formats/reader.h"

namespace etalon {

/// A keyword of a format. `read` reads its values; `Loader` has the Reader as its `in`.
template <class Loader>
struct Keyword {
    std::string_view name;
    void (*read)(Loader&);
    bool suggested = true;  ///< whether to suggest it for misspelt words
};

/// Returns the names of the keywords, for Reader, which continues there after an error.
template <class Loader, std::size_t count>
constexpr auto names_of(const std::array<Keyword<Loader>, count>& keywords) {
    std::array<std::string_view, count> names;
    std::ranges::transform(keywords, names.begin(), &Keyword<Loader>::name);
    return names;
}

/// Skips words where a keyword is expected, with one warning for all. `before` is the keyword of
/// the statement before them, or empty.
void skip_stray_words(Reader& in, std::string_view before,
                      std::span<const std::string_view> suggestions);

/// Reads the whole text. The keywords are searched in order, so the most frequent should come
/// first.
template <class Loader, std::size_t count>
void read_statements(Loader& loader, const std::array<Keyword<Loader>, count>& keywords) {
    std::vector<std::string_view> suggestions;
    for (const Keyword<Loader>& k : keywords) {
        if (k.suggested) suggestions.push_back(k.name);
    }
    Reader& in = loader.in;
    std::string_view before;
    while (!in.tokens().at_end()) {
        const auto k = std::ranges::find(keywords, in.tokens().peek(), &Keyword<Loader>::name);
        if (k == keywords.end()) {
            skip_stray_words(in, before, suggestions);
            continue;
        }
        before = in.begin();
        k->read(loader);
        if (!in.ok()) in.skip_to_keyword();
        in.recover();
    }
}

}  // namespace etalon
