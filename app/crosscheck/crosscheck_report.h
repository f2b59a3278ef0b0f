// Report of a cross-check, as text and as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/crosscheck/crosscheck_results.h"

namespace etalon::crosscheck {

/// Returns tables of errors and of the comparison of backends.
std::string as_text(const Results& results);

/// Returns the figures of each backend, of all rays and of each kind, and the pairs in
/// "contingency". "stopped" is "signal" or null.
nlohmann::ordered_json as_json(const Results& results);

/// Returns every backend's worst rays, with comments, as input of `etalon trace --rays`. Backends
/// that answer the same rays equally badly share them.
std::string as_rays(const Results& results);

}  // namespace etalon::crosscheck
