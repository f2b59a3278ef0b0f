#pragma once

#include <string>

#include "core/scene/render_settings.h"

namespace etalon {

/// Returns why the image cannot fit into this machine's memory, or into what the process may use;
/// empty if it may fit. Without this, the system ends the program after a long time.
std::string check_memory(const RenderSettings& settings);

}  // namespace etalon
