// The two axes of a plot: positions of values on the page, and values of ticks.
#pragma once

#include "bench/accuracy/report/points.h"
#include "bench/plot/plot_area.h"
#include "bench/plot/ticks.h"

namespace etalon::accuracy {

/// Logarithmic axes: of cost, and of 1 + error, so that zero error has a place.
class Axes {
  public:
    Axes(const Scatter& scatter, const plot::PlotArea& plot_area);

    const plot::PlotArea& plot_area() const { return plot_area_; }
    plot::Position position(double cost, double error) const;
    std::vector<plot::Tick> cost_ticks() const;
    std::vector<plot::Tick> error_ticks() const;

  private:
    plot::PlotArea plot_area_;
    double lowest_, highest_;  ///< log10 of the costs shown
    double worst_;             ///< log10 of 1 + the largest error shown
    bool is_relative_;
};

}  // namespace etalon::accuracy
