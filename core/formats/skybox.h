#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/file_scope.h"
#include "core/scene/environment.h"

namespace etalon {

/// The six images of a skybox, or what there is of them.
struct SkyboxFiles {
    Skybox skybox;
    std::vector<std::string> missing;  ///< names of faces without a file
    std::string objection;             ///< why a file may not be opened, if there is one
};

/// Looks for right, left, top, bottom, front and back (.jpg, .png, .exr or .hdr) in `directory`,
/// taken relative to each of `bases` in turn: the first base where none is missing, else the one
/// where fewest are. Only asks whether the files exist, and of those outside of the scope not even
/// that.
SkyboxFiles find_skybox(const std::filesystem::path& directory,
                        const std::vector<std::filesystem::path>& bases, const FileScope& scope);

}  // namespace etalon
