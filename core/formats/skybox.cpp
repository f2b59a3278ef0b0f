#include "core/formats/skybox.h"

#include <array>

namespace etalon {
namespace {

std::string find_face(const std::filesystem::path& directory, const std::string& name) {
    for (const char* extension : {".jpg", ".png", ".exr", ".hdr"}) {
        const std::filesystem::path file = directory / (name + extension);
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored)) return file.string();
    }
    return {};
}

SkyboxFiles look_in(const std::filesystem::path& directory) {
    static constexpr std::array faces = {"right", "left", "top", "bottom", "front", "back"};
    SkyboxFiles found;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        found.skybox.faces[k] = find_face(directory, faces[k]);
        if (found.skybox.faces[k].empty()) found.missing.emplace_back(faces[k]);
    }
    return found;
}

}  // namespace

SkyboxFiles find_skybox(const std::filesystem::path& directory,
                        const std::vector<std::filesystem::path>& bases) {
    SkyboxFiles best;
    for (const std::filesystem::path& base : bases) {
        SkyboxFiles found = look_in(base / directory);
        if (found.missing.empty()) return found;
        const bool better = best.missing.empty() || found.missing.size() < best.missing.size();
        if (better) best = std::move(found);
    }
    return best;
}

}  // namespace etalon
