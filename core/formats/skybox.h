#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/file_scope.h"
#include "core/scene/environment.h"

namespace etalon {

/// The six images of a skybox, as far as they were found.
struct SkyboxFiles {
    Skybox skybox;
    std::vector<std::string> missing;  ///< names of faces without a file
    std::string error;                 ///< why a file may not be opened; empty if all may
};

/// Searches for right, left, top, bottom, front and back (.jpg, .png, .exr or .hdr) in `directory`,
/// relative to each of `bases` in turn. Returns the first base where none is missing, else the one
/// where fewest are. Only tests whether the files exist; for those outside of the scope not even
/// that.
SkyboxFiles find_skybox(const std::filesystem::path& directory,
                        const std::vector<std::filesystem::path>& bases, const FileScope& scope);

}  // namespace etalon
