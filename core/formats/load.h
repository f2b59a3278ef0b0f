// Text in, scene and settings out. Loaders never print, exit or throw; they know no backend.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

inline constexpr int most_frames = 1000;  ///< that are read of one file

struct LoadOptions {
    std::string format;      ///< a format's name; empty: told from the content, then the extension
    bool strict = false;     ///< warnings are errors
    bool legacy = false;     ///< shade as the format's own old programs did
    bool one_sided = false;  ///< opaque surfaces are seen from their front only

    /// Directory outside of which the scene may open nothing, wherever links lead; empty: it may.
    std::string root;

    /// The frame that is wanted of a file with several, from 1; the last one where there are fewer.
    /// 0: the first, with a warning if there are more.
    int frame = 0;
};

struct LoadResult {
    std::optional<Scene> scene;  ///< nothing if the file holds nothing that can be rendered
    RenderSettings settings{};   ///< settings that the file gives for rendering it
    std::vector<Diagnostic> diagnostics{};
    int frames = 1;  ///< frames in the file
};

/// Reads a scene file; "-" is standard input.
LoadResult load_scene(const std::string& path, const LoadOptions& options = {});

/// The same for text in memory. `path` names it in diagnostics and tells where files it mentions
/// are looked for.
LoadResult load_scene_text(std::string_view text, const std::string& path,
                           const LoadOptions& options = {});

/// Returns the name of the format in which a text would be loaded: as asked for, else as detected.
/// Empty if there is none.
std::string_view format_of(std::string_view text, const std::string& path,
                           const LoadOptions& options = {});

/// Names of the formats that can be read.
std::span<const std::string_view> format_names();

/// Names of the formats for which LoadOptions::legacy has a meaning.
std::span<const std::string_view> legacy_names();

}  // namespace etalon
