// Values of the ticks on an axis.
#pragma once

#include <string>
#include <vector>

namespace etalon::plot {

struct Tick {
    double value;
    std::string text;
};

/// Returns "1", "10", "10³", "10⁻²".
std::string power_of_ten(int exponent);

/// Returns the ticks of a logarithmic axis from 10^low to 10^high: about two to twelve, powers of
/// ten if there are several of them, else also values in between.
std::vector<Tick> log_ticks(double low, double high);

}  // namespace etalon::plot
