#pragma once

#include "core/image/metrics/metrics.h"

namespace etalon {

/// Structural similarity, 1 for equal images. Wang et al. 2004, "Image Quality Assessment: From
/// Error Visibility to Structural Similarity": Gaussian windows of 11 x 11 pixels and deviation
/// 1.5, K1 = 0.01, K2 = 0.03. Images are linear RGB in rows of `width` pixels, and are judged as
/// a display shows them: clamped to [0, 1], NaN as black, encoded as sRGB. The mean over channels
/// and over all windows inside the image; where it has fewer than 11 rows or columns, over those
/// around all its pixels, beyond which its border goes on.
double ssim(Pixels a, Pixels b, int width);

}  // namespace etalon
