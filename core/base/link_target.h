#pragma once

#include <filesystem>

namespace etalon {

/// Returns where a file named by `path` is, or would come to be: symbolic links lead there, though
/// there be nothing yet.
inline std::filesystem::path link_target(std::filesystem::path path) {
    constexpr int most_links = 40;  // as Linux follows
    std::error_code none;
    for (int i = 0; i < most_links && std::filesystem::is_symlink(path, none); ++i) {
        path = path.parent_path() / std::filesystem::read_symlink(path);
    }
    return path;
}

}  // namespace etalon
