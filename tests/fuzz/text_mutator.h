#pragma once

#include <string>
#include <vector>

namespace etalon::fuzz {

/// Returns a text after one to four mutations at the level of words: a number is replaced, a count
/// grows or shrinks, a word becomes one of `words`, or words and lines are removed, duplicated or
/// swapped.
std::string mutated_text(const std::string& text, const std::vector<std::string>& words,
                         unsigned seed);

}  // namespace etalon::fuzz
