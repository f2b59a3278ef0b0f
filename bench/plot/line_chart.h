// Curves on two logarithmic axes.
#pragma once

#include <string>
#include <vector>

namespace etalon::plot {

struct Sample {
    double x, y;               ///< positive; what is not has no place on the chart and is left out
    double low = 0, high = 0;  ///< between which y may be; no band where they are not given
};

struct Series {
    std::string name;
    std::vector<Sample> samples;  ///< by x
};

/// Chart of at most seven series: more have no colours of their own, and cannot be told apart.
struct LineChart {
    std::string title, x_name, y_name;
    std::vector<Series> series;
};

/// An element for a page with the style sheet, small enough for a phone; each curve has its name at
/// its end. Empty if there is nothing to draw.
std::string line_chart(const LineChart& chart);

}  // namespace etalon::plot
