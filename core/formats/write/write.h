// Writing of scenes as text, for `etalon convert`.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/write/conversion_warnings.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

struct WrittenScene {
    std::string text;
    std::string_view format;              ///< name in messages: "P3F"
    std::vector<ConversionWarning> lost;  ///< warnings of what the format cannot express
};

/// Writes P3F. Reading it back gives the same image to the last bit, except for what is lost.
/// `directory` is where the file will be; skyboxes are named relative to it.
WrittenScene write_p3f(const Scene& scene, const RenderSettings& settings,
                       const std::filesystem::path& directory);

/// Writes PBRT v3. Its lights differ: they fall off, and a background lights the scene.
WrittenScene write_pbrt(const Scene& scene, const RenderSettings& settings,
                        const std::filesystem::path& directory);

using SceneWriter = WrittenScene (*)(const Scene&, const RenderSettings&,
                                     const std::filesystem::path& directory);

/// Returns the writer of files with this extension (".p3f"); null if there is none.
SceneWriter find_scene_writer(std::string_view extension);

/// Returns the names of the formats that can be written: their extensions without the dot.
std::vector<std::string> writable_formats();

/// Returns the extensions that can be written: ".p3f or ..."
std::string writable_extensions();

}  // namespace etalon
