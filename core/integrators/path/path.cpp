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

/// Returns how many of the paths are followed together: fewer than all where each vertex samples so
/// many lights that the points on them, and the shadow rays, would need much memory.
std::size_t count_together(const PathScene& scene, std::size_t paths) {
    constexpr std::size_t most_light_samples = 1 << 16;  // of about 110 bytes each
    if (!scene.samples_all || scene.lights.empty()) return paths;
    return std::max<std::size_t>(1, most_light_samples / scene.lights.samples());
}

/// Follows the paths of the samples, which do not depend on how many are followed together.
template <bool in_media>
void follow(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors,
            RayCounts& counts) {
    const std::size_t all = colors.size(), most = count_together(scene, all);
    for (std::size_t first = 0; first < all; first += most) {
        const std::size_t some = std::min(most, all - first);
        PathBatch<in_media>(
            scene, {samples.rays.subspan(first, some), samples.sources.subspan(first, some)},
            colors.subspan(first, some), counts)
            .run();
    }
}

/// Returns the emission that camera rays hit, if there is no medium in the way.
void emission_of(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors) {
    RayCounts not_of_the_image;
    PathBatch<false>(scene, samples, colors, not_of_the_image, PathLight::emission).run();
}

}  // namespace

void PathTracer::radiance(const CameraSamples& samples, std::span<Color> colors,
                          RayCounts& counts) const {
    follow<false>(scene_, samples, colors, counts);
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
        follow<true>(scene_, samples, colors, counts);
    } else {
        follow<false>(scene_, samples, colors, counts);
    }
}

void VolumePathTracer::emission(const CameraSamples& samples, std::span<Color> colors) const {
    emission_of(scene_, samples, colors);
}

}  // namespace etalon
