// Rays of a cross-check and the oracle's answers to them.
#pragma once

#include "core/oracle/oracle.h"
#include "core/test_rays/ray_sets.h"

namespace etalon::crosscheck {

/// Rays of one kind and the oracle's answer to each.
struct Trial {
    std::string kind;  ///< "camera", "bounce", "shadow" or "aimed"
    std::vector<Ray> rays;
    std::vector<OracleAnswer> truth;
};

/// Returns about `limit` rays of each kind for an image of this resolution, fewer where the scene
/// has no more, e.g. no light.
std::vector<Trial> make_trials(const Scene& scene, const Imath::V2i& resolution, std::size_t limit);

}  // namespace etalon::crosscheck
