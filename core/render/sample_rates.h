#pragma once

#include <cstdint>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/scene/camera.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Factor of the number of samples of each pixel of a window, in rows: powers of two. Empty if all
/// have the usual number.
using SampleRates = std::vector<std::uint8_t>;

/// Least number of samples per pixel of an image that may have rates.
constexpr int fewest_samples_with_rates = 8;

/// Returns higher rates for the pixels at the outlines of lights that are much brighter than the
/// surfaces they illuminate. Such pixels are few, and have nearly all the noise of an image in
/// which lights are visible. The rates depend on separate rays, since the image's own samples would
/// bias its mean; the rate of a pixel does not depend on the window. Empty if no lights are
/// visible, and for images of few samples, for which the search would not pay.
SampleRates sample_rates(const Camera& camera, const Integrator& integrator,
                         const RenderSettings& settings, const Imath::Box2i& window);

}  // namespace etalon
