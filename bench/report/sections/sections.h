// The sections of the report, each a view of what was measured. CONTRIBUTING.md lists what a new
// one takes.
#pragma once

#include "bench/report/content.h"
#include "bench/report/measured_results.h"

namespace etalon::bench_report {

Section speed_section(const Results& results);
Section builds_section(const Results& results);
Section pareto_section(const Results& results);
Section hard_cases_section(const Results& results);
Section convergence_section(const Results& results);
Section foreign_section(const Results& results);
Section images_section(const Results& results);
Section frames_section(const Results& results);
Section spd_section(const Results& results);
Section machine_section(const Results& results);

/// Returns the key figures of what was measured so far.
std::vector<KeyFigure> summary(const Results& results);

/// Returns the whole report. A section without figures is not measured yet.
Page page_of(const Results& results);

}  // namespace etalon::bench_report
