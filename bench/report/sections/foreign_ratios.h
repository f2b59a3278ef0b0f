// CPU time to equal error, ours and other programs'.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "bench/report/measured_results.h"

namespace etalon::bench_report {

/// Another program's CPU time over ours, one for each scene that both render the same.
struct ForeignRatios {
    std::string program;
    std::vector<double> ratios;
};

inline std::vector<ForeignRatios> foreign_ratios(const std::vector<ForeignFigures>& all) {
    std::vector<ForeignRatios> list;
    for (const ForeignFigures& figures : all) {
        if (!figures.missing.empty() || !figures.is_same) continue;
        for (const convergence::CurveComparison& c : figures.comparisons) {
            auto found = std::ranges::find(list, c.program, &ForeignRatios::program);
            if (found == list.end()) found = list.insert(found, {c.program, {}});
            found->ratios.push_back(c.ratio);
        }
    }
    return list;
}

}  // namespace etalon::bench_report
