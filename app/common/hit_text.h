#pragma once

#include <string>

#include "core/intersect/ray.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns "hit T SHAPE PRIMITIVE" as `trace` prints it. For an instance PRIMITIVE is "a/b": number
/// of the instance, number of the primitive in its object.
std::string hit_text(const Geometry& geometry, const Hit& hit);

}  // namespace etalon
