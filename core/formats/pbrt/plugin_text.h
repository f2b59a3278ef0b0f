#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

/// Returns the text in quotes, with escapes.
std::string quote(std::string_view text);

/// Names that stand for textures and materials by their numbers.
std::string texture_name(std::uint32_t number);
std::string material_name(std::uint32_t number);

/// Returns the parameters that are given, each under the name and type of the plugin's table, with
/// numbers that read back to the same values. Files are named from `directory`.
std::string parameters_text(const Plugin& plugin, const std::filesystem::path& directory);

/// Returns the matrix as pbrt-v3 gives one: column by column, in brackets.
std::string matrix_text(const Matrix4& matrix);

}  // namespace etalon::pbrt
