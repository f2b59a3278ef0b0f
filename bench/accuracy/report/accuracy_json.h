#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// Machine, compiler, flags and version with which the rows were measured.
struct RunEnvironment {
    std::string machine, compiler, flags, version;
};

/// This machine's processor, and this program's compiler, flags and version.
RunEnvironment run_environment();

/// Returns all results with every bit of every number. A distribution is given by its count,
/// quantiles and maximum; an infinite value is null.
nlohmann::ordered_json json(const std::vector<Row>& rows);

}  // namespace etalon::accuracy
