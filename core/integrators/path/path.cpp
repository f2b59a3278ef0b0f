#include "core/integrators/path/path.h"

#include "core/integrators/path/path_batch.h"

namespace etalon {

void PathTracer::radiance(const CameraSamples& samples, std::span<Color> colors,
                          RayCounts& counts) const {
    PathBatch(scene_, samples, colors, counts).run();
}

void PathTracer::emission(const CameraSamples& samples, std::span<Color> colors) const {
    RayCounts not_of_the_image;
    PathBatch(scene_, samples, colors, not_of_the_image, 0).run();
}

}  // namespace etalon
