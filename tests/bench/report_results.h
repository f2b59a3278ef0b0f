#pragma once

#include "bench/report/measured_results.h"

namespace etalon::test {

/// Returns made-up figures for every section of a report, with names full of HTML's special
/// characters.
bench_report::Results sample_results();

}  // namespace etalon::test
