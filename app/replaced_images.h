#pragma once

#include <string>
#include <vector>

#include "app/scene_arguments.h"

namespace etalon {

/// Warns of replaced images, once for each; returns false if that is an error. `problems` are the
/// reasons, each beginning with the path.
bool tolerates(const Scene& scene, const SceneArguments& arguments,
               const std::vector<std::string>& problems);

/// Warns of so many samples that count as black, as they are infinite or no number, and names the
/// images of the scene in which there are such values. Does nothing for 0.
void warn_of_dropped_samples(const Scene& scene, const SceneArguments& arguments,
                             std::size_t samples);

/// Adds the holes of alpha textures to a scene's geometry (see core/shading/textured_cut_outs.h)
/// and warns of their images that cannot be read; returns false if that is an error.
bool make_cut_outs(Scene& scene, const SceneArguments& arguments);

}  // namespace etalon
