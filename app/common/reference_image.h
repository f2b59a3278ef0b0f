#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/numerics/vec.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Reads the reference for the pixels of an image's window, in rows from the top, from a file of
/// the window or of the whole frame: as light, or as display values if the settings keep them. A
/// failure's reason begins with the path.
Result<std::vector<Color>> read_reference(const std::string& path, const RenderSettings& settings);

}  // namespace etalon
