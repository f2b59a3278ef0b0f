// The figures as text, for a terminal.
#pragma once

#include <string>

#include "bench/speed/figures.h"
#include "bench/table/columns.h"

namespace etalon::speed {

using table::Detail;

/// Returns a heading, and a line for each tracer and number of threads.
std::string table_of(const std::vector<BuildFigures>& builds, Detail detail);

/// Returns the heading of the tables of all kinds of rays.
std::string heading_of_rays(Detail detail);

/// Returns a line for each tracer and number of threads; errors, which do not depend on threads, in
/// the first one only. A "." is a zero.
std::string table_of(const KindFigures& kind, Detail detail);

/// Returns a heading, and a line for each tracer: geometric means of its ratios on one thread over
/// the kinds of rays, and how often it was wrong.
std::string table_of_means(const SceneFigures& scene);

/// Adds what the columns of these tables mean.
void explain_builds(Detail detail, table::Legend& legend);
void explain_rays(Detail detail, table::Legend& legend);
void explain_means(table::Legend& legend);

}  // namespace etalon::speed
