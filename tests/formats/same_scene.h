#pragma once

#include <string>

#include "core/scene/scene.h"

namespace etalon {

/// In what two scenes differ that makes a picture differ, to the last bit; empty if in nothing.
/// Arrays may be ordered differently, and planes may have normals of other lengths, by powers of
/// two.
std::string difference(const Scene& a, const Scene& b);

}  // namespace etalon
