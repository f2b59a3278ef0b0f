// The report's figures in machine-readable files.
#pragma once

#include <string>

#include "bench/report/content.h"
#include "bench/report/measured_results.h"

namespace etalon::bench_report {

/// Writes the results as data.json, and each table of the page as SECTION-TITLE.csv (RFC 4180),
/// into the folder. Returns whether all could be written; messages go to standard error.
bool write_data_files(const std::string& folder, const Results& results, const Page& page);

}  // namespace etalon::bench_report
