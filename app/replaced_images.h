#pragma once

#include <string>
#include <vector>

#include "app/scene_arguments.h"

namespace etalon {

/// Warns of replaced images, once for each; returns false if that is an error. `problems` are the
/// reasons, each beginning with the path.
bool tolerates(const Scene& scene, const SceneArguments& arguments,
               const std::vector<std::string>& problems);

/// Adds the holes of alpha textures to a scene's geometry (see core/shading/textured_cut_outs.h)
/// and warns of their images that cannot be read; returns false if that is an error.
bool make_cut_outs(Scene& scene, const SceneArguments& arguments);

}  // namespace etalon
