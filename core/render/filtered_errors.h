#pragma once

#include <vector>

#include "core/render/error_estimate.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Returns the contributions of pixel errors to an image whose filter spreads samples over several
/// pixels. Treats the means of the pixels of `samples` as independent apart from the samples'
/// positions: the squared error of a filtered value is then the sum of theirs times the mean
/// squares of their weights. `image` has the filtered values, to which errors are relative, and
/// `before` those of the last call.
FilteredErrors filtered_errors(const Film& image, const std::vector<Vec3>& before,
                               const Imath::Box2i& samples, const RenderSettings& settings);

}  // namespace etalon
