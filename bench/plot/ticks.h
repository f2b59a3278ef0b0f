// Which values are worth a tick on an axis.
#pragma once

#include <string>
#include <vector>

namespace etalon::plot {

struct Tick {
    double value;
    std::string text;
};

/// "1", "10", "10³", "10⁻²": ten to the power of a number of at most two digits.
std::string power_of_ten(int exponent);

/// For an axis by logarithms that shows values from 10^low to 10^high: some two to twelve, powers
/// of ten where there are several of them, else also what is between.
std::vector<Tick> log_ticks(double low, double high);

}  // namespace etalon::plot
