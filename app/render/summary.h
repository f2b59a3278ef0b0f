#pragma once

#include <string>

#include "app/render/arguments.h"
#include "app/render/reference.h"
#include "app/stats.h"
#include "core/render/renderer.h"
#include "core/scene/scene.h"

namespace etalon {

/// Returns the final line of a rendering on the terminal: what was rendered, how, for how long, its
/// error and its files. `reference` may be null.
std::string summary_of(const RenderArguments& arguments, const Scene& scene,
                       const Rendering& rendering, const RenderStats& stats,
                       const Reference* reference);

}  // namespace etalon
