#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/common/options.h"
#include "core/formats/load.h"
#include "core/scene/scene.h"

namespace etalon {

/// Options of every subcommand that reads a scene.
struct SceneArguments {
    std::string path;
    std::string legacy;      ///< a format's name, or empty
    std::string max_memory;  ///< a size for parse_bytes(), or empty
    LoadOptions options;
};

void declare_scene(Options& options, SceneArguments& arguments);

struct LoadedScene {
    std::optional<Scene> scene;  ///< nothing: give up with `status`
    RenderSettings settings;     ///< the file's settings
    int status = 0;
    std::vector<Diagnostic> diagnostics;
    int frames = 1;                    ///< number of frames in the file
    std::vector<std::string> files{};  ///< see scene_files()
};

/// Reports that a file has fewer frames than --frame requests; returns false if it has enough.
bool refuse_frame(const SceneArguments& arguments, int frames);

/// Reports that an output is one of the files of a scene, which it would replace; returns false if
/// none is.
bool refuse_outputs(const std::vector<std::string>& outputs,
                    const std::vector<std::string>& scene_files);

/// Limits the memory of the process by --max-memory.
void limit_memory(const SceneArguments& arguments);

/// Limits the memory of the process, loads the scene and prints its diagnostics on standard error.
/// `text` is that of the file, if it has been read already.
LoadedScene load(SceneArguments arguments, std::optional<std::string_view> text = {});

}  // namespace etalon
