#pragma once

#include <string>

#include "core/base/result.h"
#include "core/formats/diagnostic_list.h"
#include "core/scene/camera.h"

namespace etalon::pbrt {

/// Reads the surfaces of a lens: of each, from the scene to the film, radius of curvature and
/// thickness in millimetres, index of refraction, and aperture's diameter in millimetres. What is
/// no number in the file goes to `log`.
Result<std::vector<LensSurface>> read_lens_file(const std::string& path, bool strict,
                                                DiagnosticList& log);

}  // namespace etalon::pbrt
