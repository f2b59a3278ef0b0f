#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// Where and with what the rows were measured.
struct RunEnvironment {
    std::string machine, compiler, flags, version;
};

/// This machine's processor, and this program's compiler, flags and version.
RunEnvironment run_environment();

/// Everything, with every bit of every number; of a distribution its count, quantiles and maximum.
/// What is infinite is null.
nlohmann::ordered_json json(const std::vector<Row>& rows, const RunEnvironment& environment);

}  // namespace etalon::accuracy
