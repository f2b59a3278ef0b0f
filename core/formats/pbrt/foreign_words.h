#pragma once

#include <string>
#include <string_view>

#include "core/formats/pbrt/plugin_type.h"

namespace etalon::pbrt {

/// Returns whose directive it is, if it is one of another version: "PBRT version 2"; else nothing.
std::string_view origin_of_directive(std::string_view word);

/// The same for a plugin of another version or of a fork.
std::string_view origin_of_plugin(Category category, std::string_view name);

}  // namespace etalon::pbrt
