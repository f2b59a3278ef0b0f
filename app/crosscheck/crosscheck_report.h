// Report of a cross-check, as text and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/crosscheck/crosscheck_results.h"

namespace etalon::crosscheck {

/// Tables of errors and of who was right.
std::string as_text(const Results& results);

/// Returns for each backend the figures of all rays and of each kind; the pairs in "contingency".
/// "stopped" is "signal" or null.
nlohmann::ordered_json as_json(const Results& results);

/// Every backend's worst rays, comments above each, as `etalon trace --rays` takes them. Backends
/// that answer the same rays equally badly share them.
std::string as_rays(const Results& results);

}  // namespace etalon::crosscheck
