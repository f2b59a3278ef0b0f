#pragma once

#include <string>
#include <vector>

namespace etalon::fuzz {

/// Changes a text as its readers see it, one to four times: a number becomes another, a count grows
/// or shrinks, a word becomes one of `words`, words and lines are left out, doubled or change
/// places.
std::string mutated_text(const std::string& text, const std::vector<std::string>& words,
                         unsigned seed);

}  // namespace etalon::fuzz
