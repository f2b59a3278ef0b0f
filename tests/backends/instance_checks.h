// Comparisons of backends with the kernels, in scenes of instances.
#pragma once

#include <vector>

#include "core/intersect/intersector.h"

namespace etalon::test {

/// Returns the hit among all primitives and those of all instances, by the rule for ties.
Hit all_tested(const Geometry& geometry, const Ray& ray);

/// Counts rays for which any query of the backend differs from `expected`.
std::size_t count_wrong(const Backend& backend, const Geometry& geometry,
                        const std::vector<Ray>& rays, const std::vector<Hit>& expected);

/// Compares all exact backends with the kernels. Returns the number of rays that hit.
int check_all(const Geometry& geometry, const std::vector<Ray>& rays);

}  // namespace etalon::test
