#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic.h"
#include "core/formats/load.h"

namespace etalon::pbrt {

struct NormalizedFile {
    std::optional<std::string> text;  ///< nothing if pbrt-v3 would stop, or nothing is visible
    std::vector<Diagnostic> diagnostics;
    int frames = 1;  ///< frames in the file
};

/// Reads PBRT v3 and writes it as write_frames() does. `path` is the path of the text, `directory`
/// that of the result. Two of the options have an effect: with `strict`, nothing is written if
/// there is any diagnostic; without `frame`, all frames are written.
NormalizedFile normalize(std::string_view text, const std::string& path,
                         const std::filesystem::path& directory, const LoadOptions& options);

}  // namespace etalon::pbrt
