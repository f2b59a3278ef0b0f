// The "balls" of Haines 1987, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11).
#pragma once

#include <vector>

#include "core/scene/shapes.h"

namespace etalon::bench {

/// Returns a unit sphere about the origin with nine spheres of a third of its size on it, and so on
/// to `depth`: (9^(depth + 1) - 1) / 8 spheres.
std::vector<Sphere> sphereflake_spheres(std::size_t depth);

}  // namespace etalon::bench
