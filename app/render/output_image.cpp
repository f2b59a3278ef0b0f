#include "app/render/output_image.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/common/program_facts.h"
#include "core/render/camera_rays.h"

namespace etalon {
namespace {

/// Partial images say so in their metadata; an error is included if it was requested and estimated.
void add_what_was_reached(const RenderStats& stats, RenderedImage& image) {
    if (!stats.stopped.empty()) image.metadata["stopped"] = stats.stopped;
    if (stats.target_error) {
        image.metadata["targetError"] = static_cast<float>(*stats.target_error);
    }
    if (stats.expected_error) {
        image.metadata["expectedError"] = static_cast<float>(*stats.expected_error);
    }
}

}  // namespace

RenderedImage make_output_image(const Scene& scene, const RenderSettings& settings,
                                const Rendering& rendering, const RenderStats& stats) {
    const CameraRays camera(scene.camera, settings.resolution);
    RenderedImage image{settings.resolution.x,   settings.resolution.y,   rendering.film.window(),
                        rendering.film.pixels(), settings.display_colors, {}};
    image.keep_display_values = settings.keep_display_values;
    image.metadata = {{"software", fmt::format("Etalon {}", build_facts().version)},
                      {"backend", stats.backend},
                      {"scene", std::filesystem::path(stats.scene).filename().string()},
                      {"integrator", stats.integrator},
                      {"samplesPerPixel", static_cast<float>(rendering.samples)},
                      {"seed", fmt::format("{}", stats.seed)},
                      {"worldToCamera", Imath::M44f(camera.world_to_camera())}};
    if (camera.world_to_ndc()) image.metadata["worldToNDC"] = Imath::M44f(*camera.world_to_ndc());
    add_what_was_reached(stats, image);
    return image;
}

}  // namespace etalon
