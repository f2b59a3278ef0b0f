#pragma once

#include <string>
#include <vector>

namespace etalon::speed {

/// Parameters of a measurement: the tracers, the rays and the number of repeats.
struct SpeedConfig {
    std::vector<std::string> tracers;  ///< including the baselines
    std::vector<int> threads{1};       ///< 1 first; every measurement is made with each
    int repeats = 5;                   ///< alternating; medians are reported
    double oracle_seconds =
        1;  ///< CPU seconds for a kind of ray: for a sample, and again for disputed rays
    std::vector<std::string> kinds{"camera", "bounce", "shadow", "random"};  ///< of ray_kinds
    std::size_t max_rays = 1 << 18;                                          ///< of each, about
};

}  // namespace etalon::speed
