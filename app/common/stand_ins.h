// Messages about images of a scene that could not be read and were replaced.
#pragma once

#include <string>
#include <vector>

#include "core/formats/diagnostic.h"
#include "core/scene/scene.h"

namespace etalon {

/// Why an image could not be read, as read_image() says it.
struct ImageProblem {
    Severity severity;
    std::string reason;
};

/// Returns what stands in for images: for each problem a diagnostic for each statement that names
/// the image, or one about the scene's file.
std::vector<Diagnostic> stand_ins(const Scene& scene, const std::string& path,
                                  const std::vector<ImageProblem>& problems);

/// Returns these as the text of warnings, for each problem once.
std::string stand_in_warnings(const Scene& scene, const std::string& path,
                              const std::vector<std::string>& problems);

}  // namespace etalon
