#pragma once

#include "core/image/metrics/image_plane.h"
#include "core/image/metrics/metrics.h"

namespace etalon {

/// All metrics of two pictures. `flip_map` is theirs.
Metrics measure(Pixels a, Pixels reference, const PixelPlane& flip_map);

}  // namespace etalon
