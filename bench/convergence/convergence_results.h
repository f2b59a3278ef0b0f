#pragma once

#include <string>
#include <vector>

#include "bench/convergence/curve.h"

namespace etalon::convergence {

/// All that one run of the command measured.
struct Measured {
    std::string scene;
    Imath::V2i size{0, 0};
    int seeds = 0;
    std::string reference{};  ///< what the curves are compared with
    std::vector<Curve> curves{};
    std::vector<ForeignCurve> foreign{};
    bool stopped = false;  ///< by a signal: curves are missing
};

/// Writes tables to standard output, and the results to the files that are not empty; "-" is
/// standard output, the tables then go to standard error. False if a file could not be written.
bool write_results(const Measured& measured, const std::string& json, const std::string& csv);

}  // namespace etalon::convergence
