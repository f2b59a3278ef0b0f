#pragma once

#include <vector>

#include "core/intersect/ray.h"
#include "core/scene/scene.h"
#include "tests/fuzz/rays/palette.h"

namespace etalon::fuzz {

/// Rays at corners, edges, seams and silhouettes of a scene, and some of its palette's numbers
/// alone; from inside, from its points and from far away, of all times, some with an end.
std::vector<Ray> nasty_rays(const Scene& scene, std::size_t count, const NastyNumbers& numbers);

}  // namespace etalon::fuzz
