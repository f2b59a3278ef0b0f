// Rays on which backends could go different ways.
#pragma once

#include <vector>

#include "core/intersect/ray.h"
#include "core/numerics/random.h"
#include "core/scene/scene.h"

namespace etalon::test {

/// `count` rays at corners, edges, silhouettes and anywhere, from inside, outside and far away,
/// some of them axis-parallel, with denormal components, or of finite range.
std::vector<Ray> make_rays(const Scene& scene, std::size_t count, Random& random);

/// A ray and those whose range ends, or begins, at its hit exactly or one double beside it.
std::vector<Ray> around_hit(const Ray& ray, double t);

}  // namespace etalon::test
