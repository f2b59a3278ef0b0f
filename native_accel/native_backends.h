#pragma once

#include <span>

#include "core/intersect/intersector.h"

namespace etalon {

/// Returns the backends in the order of help texts. CONTRIBUTING.md lists the steps to add one.
std::span<const Backend> native_backends();

}  // namespace etalon
