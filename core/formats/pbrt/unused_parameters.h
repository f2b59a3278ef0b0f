#pragma once

#include "core/formats/pbrt/log.h"
#include "core/formats/pbrt/parameter_list.h"

namespace etalon::pbrt {

/// Warns of the parameters of a list that were not used, and names those that the plugin accepts.
void report_unused(const ParameterList& list, const PluginType& type, Log& log);

}  // namespace etalon::pbrt
