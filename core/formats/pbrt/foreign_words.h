#pragma once

#include <string>
#include <string_view>

#include "core/formats/pbrt/plugin_type.h"

namespace etalon::pbrt {

/// Returns the version that has the directive, if it is not this one: "PBRT version 2"; else
/// nothing.
std::string_view origin_of_directive(std::string_view word);

/// The same for a plugin of another version or of a fork.
std::string_view origin_of_plugin(Category category, std::string_view name);

}  // namespace etalon::pbrt
