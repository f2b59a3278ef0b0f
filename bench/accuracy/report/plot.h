// Error over cost of all tracers of a shape's cases, as SVG.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"
#include "bench/accuracy/report/points.h"

namespace etalon::accuracy {

/// Returns a separate image with titles, a key and remarks, where all tracers have labels. Empty if
/// no tracer has a cost.
std::string plot(const std::vector<Row>& rows, const std::string& shape,
                 const std::vector<std::string>& remarks);

/// Returns a part of a page, which has the titles and the key: small enough for a phone, so that
/// only the tracers in the Pareto set have labels. Empty if no tracer has a cost.
std::string small_plot(const std::vector<Row>& rows, const std::string& shape);

/// Texts of a plot: its title, and those at its axes.
struct PlotTexts {
    std::string title, cost, error;
};

/// The same for any points, all of which have a label. Empty without points.
std::string small_plot(const Scatter& scatter, const PlotTexts& texts);

}  // namespace etalon::accuracy
