#pragma once

#include "bench/report/measured_results.h"

namespace etalon::test {

/// Figures for every section of a report, measured by nobody, with names full of what HTML takes
/// for its own.
bench_report::Results sample_results();

}  // namespace etalon::test
