#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// Returns the text in at most so many columns of a terminal; a longer one has "..." for its
/// middle, more of its end left than of its beginning. What is no printable character is shown as
/// "?". A character beyond the Latin, Greek, Cyrillic and Semitic scripts counts as two columns,
/// which few are narrower than.
std::string shortened(std::string_view text, int columns);

/// Returns how far a task is as a line of at most so many columns: its name, shortened, a bar where
/// there is room for it, and the seconds since its start and until its end.
std::string progress_line(std::string_view task, double part, double seconds, int columns);

}  // namespace etalon
