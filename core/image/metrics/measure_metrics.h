#pragma once

#include "core/image/metrics/metrics.h"
#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// Returns all metrics of two images, of which `flip_map` is the FLIP map.
Metrics measure(Pixels a, Pixels reference, const PixelPlane& flip_map);

}  // namespace etalon
