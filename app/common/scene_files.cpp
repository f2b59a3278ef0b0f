#include "app/common/scene_files.h"

#include <filesystem>

namespace etalon {

std::set<std::string> image_files(const Scene& scene) {
    std::set<std::string> files;
    if (scene.is_physical()) {
        for (const NamedImage& image : scene.physical().named_images) files.insert(image.file);
    } else if (const auto& skybox = scene.whitted().environment.skybox) {
        files.insert(skybox->faces.begin(), skybox->faces.end());
    }
    return files;
}

std::vector<std::string> scene_files(const ReadLog& read, const Scene& scene) {
    std::set<std::string> files = read.paths();
    files.merge(image_files(scene));
    std::error_code none;
    std::erase_if(files, [&](const std::string& f) { return !std::filesystem::exists(f, none); });
    return {files.begin(), files.end()};
}

}  // namespace etalon
