#pragma once

#include <filesystem>

namespace etalon {

/// Returns the path of the file that `path` names, following symbolic links, even if it does not
/// exist yet.
inline std::filesystem::path link_target(std::filesystem::path path) {
    constexpr int most_links = 40;  // as Linux follows
    std::error_code none;
    for (int i = 0; i < most_links && std::filesystem::is_symlink(path, none); ++i) {
        path = path.parent_path() / std::filesystem::read_symlink(path);
    }
    return path;
}

}  // namespace etalon
