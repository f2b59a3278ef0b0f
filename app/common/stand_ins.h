// Messages about images of a scene that could not be read and were replaced.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace etalon {

/// Returns "PLACE: SEVERITY: PROBLEM; COLOUR stands in" as a line: the place of the statement that
/// names the image with whose path the problem begins, or the scene's path.
std::string stand_in_message(const Scene& scene, std::string_view path, std::string_view severity,
                             std::string_view problem);

/// Returns these messages as warnings, one for each problem.
std::string stand_in_warnings(const Scene& scene, std::string_view path,
                              const std::vector<std::string>& problems);

}  // namespace etalon
