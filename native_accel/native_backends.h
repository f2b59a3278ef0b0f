#pragma once

#include <span>

#include "core/intersect/intersector.h"

namespace etalon {

/// none, grid, bvh.
std::span<const Backend> native_backends();

}  // namespace etalon
