// Comparison of the exact backends with one another and with the oracle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/intersect/ray.h"
#include "core/scene/scene.h"

namespace etalon::fuzz {

struct Finding {
    Ray ray;
    std::string text;  ///< what each side found
};

/// Returns the hits that the reference backend finds; no_index for none.
std::vector<Hit> reference_hits(const Scene& scene, const std::vector<Ray>& rays);

/// Returns the first ray for which an exact backend finds other bits than the reference, or an
/// occlusion that contradicts the hit. Rays are traced in a batch, and every fourth also alone.
std::optional<Finding> find_disparity(const Scene& scene, const std::vector<Ray>& rays,
                                      const std::vector<Hit>& reference);

/// Returns the first ray whose hit differs from the oracle's by more than docs/accuracy.md allows.
/// Adds the number of rays that the oracle cannot decide to `undecided`.
std::optional<Finding> find_error(const Scene& scene, const std::vector<Ray>& rays,
                                  const std::vector<Hit>& reference, std::uint64_t& undecided);

/// Traces the rays and returns the first difference of either kind.
std::optional<Finding> find_difference(const Scene& scene, const std::vector<Ray>& rays);

std::string to_string(const Hit& hit);
std::string to_string(const Ray& ray);

}  // namespace etalon::fuzz
