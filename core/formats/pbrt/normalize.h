#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic.h"

namespace etalon::pbrt {

struct NormalizedFile {
    std::optional<std::string> text;  ///< nothing if pbrt-v3 would stop, or nothing is to be seen
    std::vector<Diagnostic> diagnostics;
};

/// Reads PBRT v3 and writes it as write_frames() does. `path` is where the text is from,
/// `directory` where it will be. With `strict` nothing is written if there is anything to be said.
NormalizedFile normalize(std::string_view text, const std::string& path,
                         const std::filesystem::path& directory, bool strict);

}  // namespace etalon::pbrt
