// Scenes to measure accelerators on: made here by name, or read from a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace etalon {

/// "soup:N" (N random small triangles in a cube), "spheres:N" (N random spheres in a cube),
/// "duplicates:N" (N times the same triangle), or the
/// path of a scene file. Nothing, and a message on standard error, if there is no such scene.
std::optional<Scene> bench_scene(const std::string& name);

}  // namespace etalon
