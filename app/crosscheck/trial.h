// Rays of a cross-check and the oracle's answers to them.
#pragma once

#include <atomic>
#include <functional>

#include "core/oracle/oracle.h"
#include "core/test_rays/ray_sets.h"

namespace etalon::crosscheck {

/// Progress and stop flag of a cross-check, most of whose time the oracle takes.
struct CrosscheckProgress {
    const std::atomic<bool>& stop;                        ///< if set, stop soon and keep results
    std::function<void(const std::string& stage)> begin;  ///< called before "oracle", "backends"
    std::function<void(double)> progress;  ///< called with the fraction done, from any thread
};

/// Rays of one kind and the oracle's answer to each.
struct Trial {
    std::string kind;  ///< "camera", "bounce", "shadow" or "aimed"
    std::vector<Ray> rays;
    std::vector<OracleAnswer> truth;
    double size = 1;  ///< half_size() of the scene
};

/// Returns about `limit` rays of each kind for an image of this resolution; fewer if the scene has
/// no more, e.g. no light. After a stop returns those that the oracle has answered.
std::vector<Trial> make_trials(const Scene& scene, const Imath::V2i& resolution, std::size_t limit,
                               const CrosscheckProgress& run);

}  // namespace etalon::crosscheck
