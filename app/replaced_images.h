#pragma once

#include <string>
#include <vector>

#include "app/scene_arguments.h"

namespace etalon {

/// Warns of images that something else stands in for, each once; false if that is an error.
/// `problems`: why they cannot be shown, each beginning with the path.
bool tolerates(const Scene& scene, const SceneArguments& arguments,
               const std::vector<std::string>& problems);

/// Gives a scene's geometry its holes (see core/shading/textured_cut_outs.h) and warns of images of
/// them that cannot be read; false if that is an error.
bool make_cut_outs(Scene& scene, const SceneArguments& arguments);

}  // namespace etalon
