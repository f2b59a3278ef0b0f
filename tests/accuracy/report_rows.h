// Rows to make reports of.
#pragma once

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// One with a tally of 1e6 rays, `errors` false hits among them, and t off by at most `ulps` ulp of
/// a float.
Row row(std::string id, std::string shape, std::string tracer, double ulps, std::uint64_t errors,
        double cost);

/// Two shapes, four cases, all judges, and every kind of tracer.
std::vector<Row> sample_rows();

}  // namespace etalon::accuracy
