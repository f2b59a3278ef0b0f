#pragma once

#include <vector>

#include "core/render/error_estimate.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// What errors of the pixels' samples are to an image whose filter spreads them over several. Takes
/// the means of the pixels of `samples` as far as they differ for other reasons than the samples'
/// places: the squared error of a filtered value is then the sum of theirs times the mean squares
/// of their weights. `image` has the filtered values, to which errors are relative, and `before`
/// those at the last time.
FilteredErrors filtered_errors(const Film& image, const std::vector<Vec3>& before,
                               const Imath::Box2i& samples, const RenderSettings& settings);

}  // namespace etalon
