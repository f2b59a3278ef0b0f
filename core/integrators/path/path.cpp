#include "core/integrators/path/path.h"

#include <algorithm>

#include "core/integrators/path/path_batch.h"

namespace etalon {
namespace {

/// Returns whether there are media, or surfaces without a material, through which lights shine.
bool has_media(const PhysicalLook& look) {
    return !look.media.empty() ||
           std::ranges::any_of(look.materials, [](const PhysicalMaterial& material) {
               return std::holds_alternative<NoMaterial>(material.kind);
           });
}

/// Returns the emission that camera rays hit, if there is no medium in the way.
void emission_of(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors) {
    RayCounts not_of_the_image;
    PathBatch<false>(scene, samples, colors, not_of_the_image, PathLight::emission).run();
}

}  // namespace

void PathTracer::radiance(const CameraSamples& samples, std::span<Color> colors,
                          RayCounts& counts) const {
    PathBatch<false>(scene_, samples, colors, counts).run();
}

void PathTracer::emission(const CameraSamples& samples, std::span<Color> colors) const {
    emission_of(scene_, samples, colors);
}

VolumePathTracer::VolumePathTracer(const Scene& scene, const BatchIntersector& intersector,
                                   const RenderSettings& settings,
                                   std::vector<std::string>& problems)
    : in_media_(has_media(scene.physical())),
      scene_(scene, intersector, settings, problems, in_media_) {}

void VolumePathTracer::radiance(const CameraSamples& samples, std::span<Color> colors,
                                RayCounts& counts) const {
    if (in_media_) {
        PathBatch<true>(scene_, samples, colors, counts).run();
    } else {
        PathBatch<false>(scene_, samples, colors, counts).run();
    }
}

void VolumePathTracer::emission(const CameraSamples& samples, std::span<Color> colors) const {
    emission_of(scene_, samples, colors);
}

}  // namespace etalon
