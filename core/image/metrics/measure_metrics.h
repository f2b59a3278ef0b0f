#pragma once

#include "core/image/metrics/metrics.h"
#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// All metrics of two images. `flip_map` is theirs.
Metrics measure(Pixels a, Pixels reference, const PixelPlane& flip_map);

}  // namespace etalon
