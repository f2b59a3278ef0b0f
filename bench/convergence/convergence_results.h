#pragma once

#include <string>
#include <vector>

#include "bench/convergence/curve.h"

namespace etalon::convergence {

/// Results of one run of the command.
struct Measured {
    std::string scene;
    Imath::V2i size{0, 0};
    int seeds = 0;
    std::string reference{};  ///< description of the reference
    std::vector<Curve> curves{};
    std::vector<ForeignCurve> foreign{};
    /// Why curves are missing, as in the JSON: "signal", "error", or nothing.
    std::string stopped{};
};

/// Writes tables to standard output, and the results to the files that are named; for "-", standard
/// output, the tables go to standard error. Returns false if a file could not be written.
bool write_results(const Measured& measured, const std::string& json, const std::string& csv);

/// Writes the results so far to the files that can be replaced later, since all may take hours.
void keep_results(Measured measured, const std::string& json, const std::string& csv);

}  // namespace etalon::convergence
