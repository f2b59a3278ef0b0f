// Rays on which backends could disagree.
#pragma once

#include <vector>

#include "core/intersect/ray.h"
#include "core/numerics/random.h"
#include "core/scene/scene.h"

namespace etalon::test {

/// Returns `count` rays at corners, edges, silhouettes and anywhere, from inside, outside and far
/// away, some of them axis-parallel, with denormal components, or of finite range.
std::vector<Ray> make_rays(const Scene& scene, std::size_t count, Random& random);

/// Returns a ray and those whose range ends, or begins, exactly at its hit or one double beside it.
std::vector<Ray> around_hit(const Ray& ray, double t);

}  // namespace etalon::test
