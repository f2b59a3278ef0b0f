#pragma once

#include <span>

#include "core/intersect/intersector.h"

namespace etalon {

/// embree, embree-builtin.
std::span<const Backend> embree_backends();

}  // namespace etalon
