#pragma once

#include "core/scene/geometry.h"

namespace etalon {

/// Makes room in each array for `factor` times what is in it, where that is much. An array that
/// grows by doubling is cleared and copied about twice; room that is not used costs nothing, as
/// memory is not there before it is written.
void make_room_for_growth(Geometry& geometry, double factor);

}  // namespace etalon
