#pragma once

#include <string>

#include "core/formats/load.h"

namespace etalon {

/// Returns a defect that no file may cause: an index out of bounds, a number that is not finite, a
/// negative radius or extent. Empty if there is none. The result must have a scene.
std::string insanity(const LoadResult& result);

}  // namespace etalon
