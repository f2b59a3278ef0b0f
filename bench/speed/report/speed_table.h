// The figures as text, for a terminal.
#pragma once

#include <string>

#include "bench/speed/figures.h"

namespace etalon::speed {

/// A heading, and a line for each tracer and number of threads.
std::string table(const std::vector<BuildFigures>& builds);

/// Returns the heading of the tables of all kinds of rays. Mrays are per CPU second and per wall
/// second; "of one" compares the rate of several threads with that of one.
std::string heading_of_rays();

/// A line for each tracer and number of threads; errors, which do not depend on threads, in the
/// first one only. A "." is a zero.
std::string table(const KindFigures& kind);

/// One line: geometric means over the kinds of rays of every tracer's ratios on one thread, and
/// how often it was wrong.
std::string summary(const SceneFigures& scene);

}  // namespace etalon::speed
