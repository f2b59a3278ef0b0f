// Rows of made-up reports.
#pragma once

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// Returns a row with 1e6 rays, `errors` false hits among them, and t off by at most `ulps` ulp of
/// a float.
Row row(std::string id, std::string shape, std::string tracer, double ulps, std::uint64_t errors,
        double cost);

/// Returns rows of two shapes and four cases, with all criteria and every kind of tracer.
std::vector<Row> sample_rows();

}  // namespace etalon::accuracy
