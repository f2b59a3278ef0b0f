#pragma once

#include <string>

#include "core/base/result.h"
#include "core/formats/diagnostic_list.h"
#include "core/scene/camera.h"

namespace etalon::pbrt {

/// Reads the surfaces of a lens. Each has, from the scene to the film, radius of curvature and
/// thickness in millimetres, index of refraction, and diameter of the aperture in millimetres.
/// Words that are not numbers are reported to `log`.
Result<std::vector<LensSurface>> read_lens_file(const std::string& path, bool strict,
                                                DiagnosticList& log);

}  // namespace etalon::pbrt
