#pragma once

#include "core/scene/geometry.h"

namespace etalon {

/// Reserves space in each array for `factor` times its contents, if that is much. An array that
/// grows by doubling is cleared and copied about twice. Unused space costs nothing, since the
/// system provides memory only when it is written.
void make_room_for_growth(Geometry& geometry, double factor);

}  // namespace etalon
