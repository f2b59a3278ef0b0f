// The two axes of a plot: where a value is on the page, and which values are worth a tick.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/report/points.h"
#include "bench/accuracy/report/svg.h"

namespace etalon::accuracy {

struct Tick {
    double value;
    std::string text;
};

/// Cost by its logarithm, error by that of 1 + error, so that there is a place for none.
class Axes {
  public:
    static constexpr double width = 760, height = 500;
    static constexpr double left = 72, right = 728, top = 120, bottom = 426;

    explicit Axes(const Scatter& scatter);

    Place place(double cost, double error) const;
    std::vector<Tick> cost_ticks() const;
    std::vector<Tick> error_ticks() const;

  private:
    double lowest_, highest_;  ///< log10 of the costs shown
    double worst_;             ///< log10 of 1 + the largest error shown
    bool is_relative_;
};

}  // namespace etalon::accuracy
