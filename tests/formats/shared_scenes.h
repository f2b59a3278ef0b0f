// Real scenes, if this machine has them.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace etalon {

inline std::filesystem::path shared_scenes_folder() {
    const char* const named = std::getenv("ETALON_SHARED_SCENES");
    return named ? std::filesystem::path(named)
                 : std::filesystem::path(ETALON_SOURCE_DIR) / "../shared/scenes";
}

/// Returns the path of NAME.FORMAT in the format's folder, which need not exist.
inline std::string shared_scene(const std::string& format, const std::string& name) {
    return shared_scenes_folder() / format / (name + "." + format);
}

/// Returns all files of an extension in a folder of the scenes; none if the folder does not exist.
inline std::vector<std::string> shared_scenes(const std::string& folder,
                                              const std::string& extension) {
    std::vector<std::string> list;
    std::error_code missing;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::directory_iterator(shared_scenes_folder() / folder, missing)) {
        if (entry.path().extension() == extension) list.push_back(entry.path().string());
    }
    return list;
}

}  // namespace etalon
