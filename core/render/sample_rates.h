#pragma once

#include <cstdint>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/scene/camera.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// How many times the usual number of samples each pixel of a window has, by rows: powers of two.
/// Empty: all have the usual number.
using SampleRates = std::vector<std::uint8_t>;

/// More samples for the pixels at the outlines of lights that are much brighter than what they
/// light up: few in an image, and with all its noise where a light is seen. The rates depend on
/// rays of their own, not on the image's samples, which would bias its mean, and those of a pixel
/// neither on the window. Empty where no lights are seen and for images of few samples, whose time
/// is not worth a look.
SampleRates sample_rates(const Camera& camera, const Integrator& integrator,
                         const RenderSettings& settings, const Imath::Box2i& window);

}  // namespace etalon
