// Loading of scenes from text. Loaders never print, exit or throw, and depend on no backend.
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

inline constexpr int most_frames = 1000;  ///< most frames that are read from one file

struct LoadOptions {
    std::string format;      ///< a format's name; empty: detected from content, then extension
    bool strict = false;     ///< warnings are errors
    bool legacy = false;     ///< shade as the original programs of the format did
    bool one_sided = false;  ///< opaque surfaces are visible only from their front

    /// Directory outside of which the scene may open no file, after resolving links; empty: no
    /// limit.
    std::string root;

    /// Number of the frame to load from a file with several, from 1; the last one if there are
    /// fewer. 0: the first, with a warning if there are more.
    int frame = 0;

    /// Name of the integrator that renders instead of the file's, for warnings about what it leaves
    /// out; empty: the file's.
    std::string integrator{};
};

struct LoadResult {
    std::optional<Scene> scene;  ///< nothing if the file has nothing that can be rendered
    RenderSettings settings{};   ///< settings that the file specifies
    std::vector<Diagnostic> diagnostics{};
    int frames = 1;  ///< frames in the file
};

/// Reads a scene file; "-" is standard input.
LoadResult load_scene(const std::string& path, const LoadOptions& options = {});

/// The same for text in memory. `path` names it in diagnostics, and files that it mentions are
/// relative to it.
LoadResult load_scene_text(std::string_view text, const std::string& path,
                           const LoadOptions& options = {});

/// Returns the name of the format in which a text would be loaded: the requested one, else the
/// detected one. Empty if there is none.
std::string_view format_of(std::string_view text, const std::string& path,
                           const LoadOptions& options = {});

/// Returns the names of the formats that can be read.
std::span<const std::string_view> format_names();

/// Returns the names of the formats for which LoadOptions::legacy has an effect.
std::span<const std::string_view> legacy_names();

}  // namespace etalon
