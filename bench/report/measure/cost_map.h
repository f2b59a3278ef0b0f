// Cost of each pixel of an image, in counts that do not depend on the machine's load.
#pragma once

#include <optional>

#include "bench/report/tasks.h"
#include "core/image/metrics/pixel_plane.h"
#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon::bench_report {

/// Returns the number of rays of a sample for each pixel, of any kind; nothing if it was over
/// early.
std::optional<PixelPlane> rays_of_samples(const Scene& scene, const RenderSettings& settings,
                                          const TaskProgress& task_progress);

/// Returns the number of boxes and primitives a camera ray is tested against by a backend; nothing
/// if that does not count.
std::optional<PixelPlane> tests_of_camera_rays(const Scene& scene, const RenderSettings& settings,
                                               const std::string& backend,
                                               const TaskProgress& task_progress);

}  // namespace etalon::bench_report
