// Small scenes that show a plugin of any category.
#pragma once

#include <string>

#include "core/formats/pbrt/plugin_type.h"

namespace etalon::test {

/// Returns the text of a scene in which a plugin with the parameters `parameters` is visible;
/// `textures` are the statements of the textures that the parameters name.
std::string world_with(const pbrt::PluginType& plugin, const std::string& parameters,
                       const std::string& textures = {});

/// Writes the files that scenes and rows name into a folder.
void write_files(const std::string& folder);

}  // namespace etalon::test
