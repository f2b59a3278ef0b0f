// The two axes of a plot: where a value is on the page, and which values are worth a tick.
#pragma once

#include "bench/accuracy/report/points.h"
#include "bench/plot/plot_area.h"
#include "bench/plot/ticks.h"

namespace etalon::accuracy {

/// Cost by its logarithm, error by that of 1 + error, so that there is a place for none.
class Axes {
  public:
    Axes(const Scatter& scatter, const plot::PlotArea& plot_area);

    const plot::PlotArea& plot_area() const { return plot_area_; }
    plot::Place place(double cost, double error) const;
    std::vector<plot::Tick> cost_ticks() const;
    std::vector<plot::Tick> error_ticks() const;

  private:
    plot::PlotArea plot_area_;
    double lowest_, highest_;  ///< log10 of the costs shown
    double worst_;             ///< log10 of 1 + the largest error shown
    bool is_relative_;
};

}  // namespace etalon::accuracy
