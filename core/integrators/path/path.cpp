#include "core/integrators/path/path.h"

#include "core/integrators/path/path_batch.h"

namespace etalon {

void PathTracer::radiance(const CameraSamples& samples, std::span<Color> colors,
                          RayCounts& counts) const {
    PathBatch(scene_, samples, colors, counts).run();
}

}  // namespace etalon
