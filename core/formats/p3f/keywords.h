#pragma once

#include <span>
#include <string_view>

#include "core/formats/p3f/loader.h"

namespace etalon::p3f {

/// What reads the statement of this keyword; null if it is none.
Handler find_handler(std::string_view keyword);

/// The format's own keywords, for suggestions.
std::span<const std::string_view> keyword_names();

/// Passes over everything up to the next keyword. Returns how many words that were.
std::size_t skip_to_keyword(Reader& in);

}  // namespace etalon::p3f
