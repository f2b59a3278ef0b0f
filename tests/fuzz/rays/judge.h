// Answers to rays, and what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/intersect/ray.h"
#include "core/scene/scene.h"

namespace etalon::fuzz {

struct Finding {
    Ray ray;
    std::string text;  ///< who says what
};

/// Returns the hits that the reference backend finds; no_index for none.
std::vector<Hit> reference_hits(const Scene& scene, const std::vector<Ray>& rays);

/// Returns the first ray to which an exact backend, asked in a batch or, every fourth, alone, gives
/// other bits than the reference, or an occlusion that contradicts its hit.
std::optional<Finding> find_disparity(const Scene& scene, const std::vector<Ray>& rays,
                                      const std::vector<Hit>& reference);

/// Returns the first ray of which the oracle says otherwise, within what docs/accuracy.md promises.
/// Adds the number of rays that it cannot decide.
std::optional<Finding> find_error(const Scene& scene, const std::vector<Ray>& rays,
                                  const std::vector<Hit>& reference, std::uint64_t& undecided);

/// Returns the first difference of either kind, asking for the hits anew.
std::optional<Finding> find_difference(const Scene& scene, const std::vector<Ray>& rays);

std::string to_string(const Hit& hit);
std::string to_string(const Ray& ray);

}  // namespace etalon::fuzz
