#pragma once

#include <string_view>

namespace etalon {

/// Returns the page of `etalon serve`: HTML that uses only what is served beside it.
std::string_view page_text();

}  // namespace etalon
