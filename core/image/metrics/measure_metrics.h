#pragma once

#include "core/image/metrics/metrics.h"
#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// All metrics of two images, and their FLIP map.
struct MeasuredMetrics {
    Metrics metrics;
    PixelPlane flip_map;
};

/// Measures images in rows of `width` pixels. If they are `display_values`, FLIP and SSIM, which
/// are about what is seen, compare the light for which these stand.
MeasuredMetrics measure(Pixels a, Pixels reference, int width, bool display_values = false);

}  // namespace etalon
