// Error against cost of all that took part in a shape's cases, as SVG.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"
#include "bench/accuracy/report/points.h"

namespace etalon::accuracy {

/// An image by itself, with titles, a key and remarks, where everybody has a label. Empty if nobody
/// has a cost.
std::string plot(const std::vector<Row>& rows, const std::string& shape,
                 const std::vector<std::string>& remarks);

/// A part of a page, which has the titles and the key: small enough for a phone, so that only who
/// is in the Pareto set has a label. Empty if nobody has a cost.
std::string small_plot(const std::vector<Row>& rows, const std::string& shape);

/// What a plot is of: its title, and the texts at its axes.
struct PlotTexts {
    std::string title, cost, error;
};

/// The same of any points, all of which have a label. Empty without points.
std::string small_plot(const Scatter& scatter, const PlotTexts& texts);

}  // namespace etalon::accuracy
