#pragma once

#include <string>
#include <string_view>

namespace etalon {

/// Returns the text shortened to at most so many columns of a terminal: a longer one gets "..." in
/// its middle, with more left of its end than of its beginning. Unprintable characters are shown as
/// "?". A character beyond the Latin, Greek, Cyrillic and Semitic scripts counts as two columns,
/// which is the width of nearly all of them.
std::string shortened(std::string_view text, int columns);

/// Returns the progress of a task as a line of at most so many columns: its name, shortened, a bar
/// if there is room for it, and the seconds since its start and until its expected end.
std::string progress_line(std::string_view task, double part, double seconds, int columns);

}  // namespace etalon
