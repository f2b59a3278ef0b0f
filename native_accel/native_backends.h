#pragma once

#include <span>

#include "core/intersect/intersector.h"

namespace etalon {

/// In the order of help texts. CONTRIBUTING.md lists what a new one takes.
std::span<const Backend> native_backends();

}  // namespace etalon
