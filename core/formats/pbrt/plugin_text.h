#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

/// Returns the text in quotes, with escapes.
std::string quote(std::string_view text);

/// Return the names of textures and materials, made from their numbers.
std::string texture_name(std::uint32_t number);
std::string material_name(std::uint32_t number);

/// Returns the parameters that are given, each under the name and type in the plugin's table, with
/// numbers that read back to the same values. Paths of files are relative to `directory`.
std::string parameters_text(const Plugin& plugin, const std::filesystem::path& directory);

/// Returns the matrix as pbrt-v3 writes it: column by column, in brackets.
std::string matrix_text(const Matrix4& matrix);

}  // namespace etalon::pbrt
