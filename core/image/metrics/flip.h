// LDR-FLIP, the visible difference of two images that alternate in the same place. Andersson et al.
// 2020, "FLIP: A Difference Evaluator for Alternating Images".
#pragma once

#include "core/image/metrics/metrics.h"
#include "core/image/metrics/pixel_plane.h"

namespace etalon {

/// Returns the visible difference at each pixel, in [0, 1], at the paper's distance to its display:
/// 67 pixels per degree. Images are linear RGB in rows of `width` pixels, and are compared as
/// displayed: clamped to [0, 1], NaN as black.
PixelPlane flip_map(Pixels a, Pixels b, int width);

/// Returns the mean of that map: FLIP as one number.
double flip(const PixelPlane& map);

}  // namespace etalon
