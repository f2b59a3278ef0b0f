// Scenes to measure accelerators on: made here by name, or read from a file.
#pragma once

#include <optional>
#include <string>

#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon::bench {

/// Returns an error message for a scene's name; empty if it is "FAMILY" or "FAMILY:SIZE" with a
/// family of bench/scenes/bench_families.h, or the path of a file.
std::string complaint_about(const std::string& name);

struct NamedScene {
    std::optional<Scene> scene;  ///< nothing if there is no such scene
    RenderSettings settings;     ///< how it is to be rendered
    std::string messages;        ///< for the user, whole lines
};

NamedScene bench_scene(const std::string& name);

/// Makes an image `width` pixels wide and as much higher or lower; not at all for 0.
void set_width(Imath::V2i& resolution, int width);

/// A line for each family: its name with its usual size, and what it is.
std::string list_of_scenes();

}  // namespace etalon::bench
