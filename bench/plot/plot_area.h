#pragma once

#include "bench/plot/svg.h"

namespace etalon::plot {

/// An image, and the area in it that the axes enclose, in pixels.
struct PlotArea {
    double width, height;
    double left, right, top, bottom;

    /// Returns the position at the fractions (x, y) of the area, from its lower left.
    Position position(double x, double y) const {
        return {left + x * (right - left), bottom - y * (bottom - top)};
    }
};

}  // namespace etalon::plot
