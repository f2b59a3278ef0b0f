#pragma once

#include "core/scene/render_settings.h"

namespace etalon {

inline constexpr int max_image_side = 65536;  ///< pixels

/// Sets the size of the image in pixels. Its crop window, if it has one, becomes the same part of
/// the new image: at least one pixel, and without overlap for adjacent windows.
void resize(RenderSettings& settings, const Imath::V2i& size);

}  // namespace etalon
