#include "core/formats/skybox.h"

#include <array>

namespace etalon {
namespace {

/// Returns the path of a face's image, empty if there is none or it may not be opened.
std::string find_face(const std::filesystem::path& directory, const std::string& name,
                      const FileScope& scope, std::string& error) {
    for (const char* extension : {".jpg", ".png", ".exr", ".hdr"}) {
        const std::filesystem::path file = directory / (name + extension);
        std::error_code ignored;
        if (std::string why = scope.check(file); !why.empty()) {
            if (error.empty()) error = std::move(why);
        } else if (std::filesystem::is_regular_file(file, ignored)) {
            return file.string();
        }
    }
    return {};
}

SkyboxFiles look_in(const std::filesystem::path& directory, const FileScope& scope) {
    static constexpr std::array faces = {"right", "left", "top", "bottom", "front", "back"};
    SkyboxFiles found;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        found.skybox.faces[k] = find_face(directory, faces[k], scope, found.error);
        if (found.skybox.faces[k].empty()) found.missing.emplace_back(faces[k]);
    }
    return found;
}

}  // namespace

SkyboxFiles find_skybox(const std::filesystem::path& directory,
                        const std::vector<std::filesystem::path>& bases, const FileScope& scope) {
    SkyboxFiles best;
    for (const std::filesystem::path& base : bases) {
        SkyboxFiles found = look_in(base / directory, scope);
        if (found.missing.empty()) return found;
        const bool better = best.missing.empty() || found.missing.size() < best.missing.size();
        if (better) best = std::move(found);
    }
    return best;
}

}  // namespace etalon
