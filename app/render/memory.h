#pragma once

#include <string>

#include "app/render/arguments.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Returns why the image cannot fit into this machine's memory, or into the process's limit; empty
/// if it may fit. Otherwise the system would kill the program after a long time.
std::string check_memory(const RenderArguments& a, const RenderSettings& settings);

}  // namespace etalon
