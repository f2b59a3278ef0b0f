#pragma once

#include <span>

#include "core/intersect/intersector.h"

namespace etalon {

/// embree, embree-builtin. Where Embree cannot be used, building throws std::runtime_error with the
/// reason.
std::span<const Backend> embree_backends();

}  // namespace etalon
