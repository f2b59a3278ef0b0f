#pragma once

#include "app/stats.h"
#include "core/image/rendered_image.h"
#include "core/render/renderer.h"

namespace etalon {

/// What is written of a rendering, and how it was made. Without channels.
RenderedImage make_output_image(const Scene& scene, const RenderSettings& settings,
                                const Rendering& rendering, const RenderStats& stats);

}  // namespace etalon
