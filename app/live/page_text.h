#pragma once

#include <string_view>

namespace etalon {

/// The page of `etalon serve`: HTML that needs nothing from elsewhere but what is served beside it.
std::string_view page_text();

}  // namespace etalon
