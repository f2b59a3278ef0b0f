#pragma once

#include <string>
#include <vector>

#include "bench/hard_cases/hard_case.h"
#include "core/base/result.h"

namespace etalon::hard {

/// Returns the cases with these names, all of them without a name: "SPH" is the name of all whose
/// ids begin with it, "SPH-1" of that id, and "SPH-1/1e3" of those of its variants that begin with
/// "1e3". `words` are a list that was split at all commas, also at those within a name, as
/// "SPH-1/1e3 radii, float". The error begins with a name that no case has.
Result<std::vector<HardCase>> cases_named(const std::vector<std::string>& words);

}  // namespace etalon::hard
