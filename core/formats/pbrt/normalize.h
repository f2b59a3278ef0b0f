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
    std::optional<std::string> text;  ///< nothing if pbrt-v3 would stop, or nothing is to be seen
    std::vector<Diagnostic> diagnostics;
    int frames = 1;  ///< frames in the file
};

/// Reads PBRT v3 and writes it as write_frames() does. `path` is where the text is from,
/// `directory` where it will be. Of the options `strict`, with which nothing is written if there is
/// anything to be said, and `frame`, without which all frames are written, have a meaning.
NormalizedFile normalize(std::string_view text, const std::string& path,
                         const std::filesystem::path& directory, const LoadOptions& options);

}  // namespace etalon::pbrt
