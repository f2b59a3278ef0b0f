// LDR-FLIP, the difference seen when two images alternate in the same place. Andersson et al.
// 2020, "FLIP: A Difference Evaluator for Alternating Images".
#pragma once

#include "core/image/metrics/metrics.h"
#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// The difference seen at each pixel, in [0, 1], at the paper's distance to its display: 67 pixels
/// a degree. Images are linear RGB in rows of `width` pixels, and are seen as a display shows
/// them: clamped to [0, 1], NaN as black.
PixelPlane flip_map(Pixels a, Pixels b, int width);

/// The mean of that map: FLIP as one number.
double flip(const PixelPlane& map);

}  // namespace etalon
