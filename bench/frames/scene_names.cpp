#include "bench/frames/scene_names.h"

#include <algorithm>
#include <filesystem>

namespace etalon::frames {
namespace {

namespace fs = std::filesystem;

/// Returns the last part of a path with so many folders, without extension; all of the path if it
/// has no more.
std::string ending(const fs::path& path, int folders) {
    fs::path name = path.stem();
    fs::path above = path.parent_path();
    for (; folders > 0 && above.has_filename(); --folders, above = above.parent_path()) {
        name = above.filename() / name;
    }
    return folders > 0 ? path.string() : name.string();
}

}  // namespace

std::string short_name(const std::string& scene, const std::vector<std::string>& scenes) {
    for (int folders = 0;; ++folders) {
        const std::string name = ending(scene, folders);
        const bool is_alone = std::ranges::none_of(scenes, [&](const std::string& other) {
            return other != scene && ending(other, folders) == name;
        });
        if (is_alone || name == scene) return name;
    }
}

}  // namespace etalon::frames
