#pragma once

#include "core/image/metrics/metrics.h"

namespace etalon {

/// Returns the structural similarity, 1 for equal images. Wang et al. 2004, "Image Quality
/// Assessment: From Error Visibility to Structural Similarity": Gaussian windows of 11 x 11 pixels
/// and deviation 1.5, K1 = 0.01, K2 = 0.03. Images are linear RGB in rows of `width` pixels, and
/// are compared as displayed: clamped to [0, 1], NaN as black, encoded as sRGB. The result is the
/// mean over channels and over all windows inside the image. If the image has fewer than 11 rows or
/// columns, it is the mean over the windows around all pixels, with the image's border continued.
double ssim(Pixels a, Pixels b, int width);

}  // namespace etalon
