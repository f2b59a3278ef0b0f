// The report's figures in machine-readable files.
#pragma once

#include <string>
#include <vector>

#include "bench/report/content.h"
#include "bench/report/measured_results.h"

namespace etalon::bench_report {

/// Writes the results as data.json into the folder. Returns whether it could be written; messages
/// go to standard error.
bool write_data(const std::string& folder, const Results& results, const Page& page);

/// The same for each table of the page, as SECTION-TITLE.csv (RFC 4180).
bool write_tables(const std::string& folder, const Page& page);

/// Returns the names of the folder's tables that the page does not have: an earlier report had
/// them.
std::vector<std::string> old_tables(const std::string& folder, const Page& page);

/// Returns whether a file in the report's folder has a name that the page, the data or a table of
/// one of the page's sections may have.
bool is_file_of_report(const std::string& name, const Page& page);

}  // namespace etalon::bench_report
