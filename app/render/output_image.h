#pragma once

#include "app/stats.h"
#include "core/image/rendered_image.h"
#include "core/render/renderer.h"

namespace etalon {

/// Returns the image to write, with metadata; its AOV channels are not added here.
RenderedImage make_output_image(const Scene& scene, const RenderSettings& settings,
                                const Rendering& rendering, const RenderStats& stats);

}  // namespace etalon
