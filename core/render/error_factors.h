#pragma once

#include <vector>

#include "core/render/film.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// What a squared error of each pixel's samples adds to the relMSE of an image whose filter spreads
/// them over several pixels, by channels: the mean over the pixels of `samples` is that of the
/// image. `image` has the filtered values, to which errors are relative.
///
/// As far as samples differ for other reasons than their place in the pixel, the error of a
/// filtered value is the sum of the squared errors of the pixels about it times the mean squares of
/// their weights.
std::vector<Vec3> error_factors(const Film& image, const Imath::Box2i& samples,
                                const RenderSettings& settings);

}  // namespace etalon
