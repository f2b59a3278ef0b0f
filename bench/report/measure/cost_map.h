#pragma once

#include "bench/report/tasks.h"
#include "core/image/metrics/pixel_plane.h"
#include "core/scene/scene.h"

namespace etalon::bench_report {

/// How many rays a sample takes, of whatever kind, in each pixel: a cost that no clock disturbs.
PixelPlane cost_map(const Scene& scene, int samples_per_pixel, const Context& context);

}  // namespace etalon::bench_report
