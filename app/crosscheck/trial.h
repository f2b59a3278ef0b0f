// Rays of a cross-check and the oracle's answers to them.
#pragma once

#include <atomic>
#include <functional>

#include "core/oracle/oracle.h"
#include "core/test_rays/ray_sets.h"

namespace etalon::crosscheck {

/// How to watch and to stop a cross-check, most of whose time the oracle takes.
struct RunControl {
    const std::atomic<bool>& stop;                        ///< set: give up soon, keep what there is
    std::function<void(const std::string& stage)> begin;  ///< called before "oracle", "backends"
    std::function<void(double)> progress;  ///< with the part of the stage done, from any thread
};

/// Rays of one kind and the oracle's answer to each.
struct Trial {
    std::string kind;  ///< "camera", "bounce", "shadow" or "aimed"
    std::vector<Ray> rays;
    std::vector<OracleAnswer> truth;
};

/// Returns about `limit` rays of each kind for an image of this resolution, fewer where the scene
/// has no more, e.g. no light; after a stop those that the oracle has answered.
std::vector<Trial> make_trials(const Scene& scene, const Imath::V2i& resolution, std::size_t limit,
                               const RunControl& run);

}  // namespace etalon::crosscheck
