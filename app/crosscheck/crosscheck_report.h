// What a cross-check found out, to read and to process.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/crosscheck/crosscheck_results.h"

namespace etalon::crosscheck {

/// Tables of errors and of who was right.
std::string as_text(const Results& results);

/// Per backend the figures of all rays and, by kind, of each; and the pairs under "contingency".
nlohmann::ordered_json as_json(const Results& results);

/// Every backend's worst rays, comments above each, as `etalon trace --rays` takes them. Backends
/// that answer the same rays equally badly share them.
std::string as_rays(const Results& results);

}  // namespace etalon::crosscheck
