// The files of which a scene is made: no output may replace one of them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/base/read_log.h"
#include "core/scene/scene.h"

namespace etalon {

/// Returns the paths of the images of a scene, whether or not they exist; an empty one if a name is
/// missing.
std::set<std::string> image_files(const Scene& scene);

/// Returns the files of a loaded scene that exist: those that `read` has recorded while it was
/// loaded, and its images, which are read when they are needed.
std::vector<std::string> scene_files(const ReadLog& read, const Scene& scene);

}  // namespace etalon
