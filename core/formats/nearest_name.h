#pragma once

#include <span>
#include <string>
#include <string_view>

namespace etalon {

/// Returns the name that `word` was probably meant to be: the one with the fewest typing errors
/// (letters added, lost, exchanged or swapped with their neighbour), ignoring case. On a tie, the
/// one that shares the longest prefix with the word, then the first. Empty if none is close enough
/// to be worth a suggestion.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

/// Returns "; did you mean 'name'?", or nothing if no name is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> names);

}  // namespace etalon
