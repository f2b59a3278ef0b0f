// Results of the measurements on a scene.
#pragma once

#include <string>
#include <vector>

#include "app/common/stopwatch.h"
#include "bench/speed/disagreement.h"
#include "bench/speed/oracle_check.h"
#include "bench/statistics/statistics.h"
#include "core/intersect/backend_roles.h"

namespace etalon::speed {

using statistics::Estimate, statistics::estimate, statistics::geometric_mean, statistics::median;

/// Names of the tracers with which every other is compared, in the same run.
inline constexpr const char* baseline = baseline_backend;
inline constexpr const char* robust_baseline = "embree-builtin-robust";

/// Repeats of the same work on a number of threads.
struct Runs {
    int threads = 1;
    std::vector<Duration> repeats;
    Estimate ratio,
        ratio_robust;  ///< of CPU seconds, the baseline's over these: above 1 is faster
    /// Seconds on one thread over these: the efficiency of a thread, and the speed-up. 1 for one
    /// thread.
    Estimate cpu_scaling, wall_scaling;

    std::vector<double> cpu() const;
    std::vector<double> wall() const;
};

/// Returns empty runs for each number of threads.
std::vector<Runs> runs_on(const std::vector<int>& threads);

struct BuildFigures {
    std::string tracer, isa;
    double bytes_per_primitive = 0;
    std::vector<Runs> by_threads;
};

/// Errors of a tracer, without which its speed means nothing.
struct Errors {
    std::string reference;      ///< the exact backend with which all answers are compared
    Disagreement disagreement;  ///< with the reference
    OracleCheck sample;         ///< by the oracle, for rays spread evenly over all
    /// Errors, by the oracle, among the rays to which not all tracers give the same answer. A
    /// tracer that alone is wrong is found here.
    OracleCheck disputed;
};

struct RayFigures {
    std::string tracer;
    std::vector<Runs> by_threads;
    Errors errors;
};

struct KindFigures {
    std::string kind;        ///< kind of ray
    std::size_t rays = 0;    ///< number of rays of each repeat
    bool occlusion = false;  ///< rays are occlusion queries
    std::vector<RayFigures> tracers;
};

struct SceneFigures {
    std::string scene;
    std::size_t primitives = 0;
    std::string shape;  ///< shape of nearly all primitives; "mixed" if there is none
    std::vector<BuildFigures> builds;
    std::vector<KindFigures> kinds;
};

/// Leaves only the first so many repeats of each tracer, those that all of them have.
void keep_repeats(std::vector<BuildFigures>& all, int repeats);
void keep_repeats(std::vector<RayFigures>& all, int repeats);

/// Fills in the comparisons of each tracer's repeats with the baselines', and with its own on one
/// thread. The baselines must be among them.
void compare_with_baselines(std::vector<BuildFigures>& all);
void compare_with_baselines(std::vector<RayFigures>& all);

}  // namespace etalon::speed
