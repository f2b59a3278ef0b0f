// Curves on two logarithmic axes.
#pragma once

#include <string>
#include <vector>

namespace etalon::plot {

struct Sample {
    double x, y;               ///< must be positive to be shown
    double low = 0, high = 0;  ///< range of y; no band if they are not given
};

struct Series {
    std::string name;
    std::vector<Sample> samples;  ///< by x
};

/// Chart of at most seven series, since there are no more distinguishable colours.
struct LineChart {
    std::string title, x_name, y_name;
    std::vector<Series> series;
};

/// Returns an element for a page with the style sheet, small enough for a phone; each curve has its
/// name at its end. Empty if there is nothing to draw.
std::string line_chart(const LineChart& chart);

}  // namespace etalon::plot
