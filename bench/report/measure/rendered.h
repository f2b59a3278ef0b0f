// The project's scenes, and scenes rendered.
#pragma once

#include <string>

#include "app/common/stopwatch.h"
#include "bench/report/tasks.h"
#include "core/render/renderer.h"

namespace etalon::bench_report {

struct ShippedScene {
    Scene scene;
    RenderSettings settings;
};

/// Returns the path of a scene below the project's folder of scenes, which is looked for here and
/// where the program was built.
std::string shipped_path(const std::string& name);

/// Returns that scene; nothing, after a message on standard error, if it cannot be read.
std::optional<ShippedScene> shipped_scene(const std::string& name);

/// Returns the same, to be rendered at that size.
std::optional<ShippedScene> shipped_scene(const std::string& name, int width, int height);

RunControl control_of(const TaskProgress& task_progress);

struct Rendered {
    Rendering rendering;
    Duration build, render;
    std::size_t bytes = 0;  ///< of the accelerator
};

Rendered rendered(const Scene& scene, const std::string& backend, const RenderSettings& settings,
                  const RunControl& control);

}  // namespace etalon::bench_report
