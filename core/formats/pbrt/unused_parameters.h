#pragma once

#include "core/formats/pbrt/log.h"
#include "core/formats/pbrt/parameter_list.h"

namespace etalon::pbrt {

/// Warns of the parameters of a list that nothing has used, and of what the plugin would take.
void report_unused(const ParameterList& list, const PluginType& type, Log& log);

}  // namespace etalon::pbrt
