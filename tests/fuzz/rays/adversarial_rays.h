#pragma once

#include <vector>

#include "core/intersect/ray.h"
#include "core/scene/scene.h"
#include "tests/fuzz/rays/palette.h"

namespace etalon::fuzz {

/// Returns rays at vertices, edges, seams and silhouettes of a scene, and some made of the
/// palette's numbers alone. Origins are inside, on surfaces and far away; times vary; some rays
/// have a tmin or tmax.
std::vector<Ray> adversarial_rays(const Scene& scene, std::size_t count,
                                  const AdversarialNumbers& numbers);

}  // namespace etalon::fuzz
