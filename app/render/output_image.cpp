#include "app/render/output_image.h"

#include <fmt/format.h>

#include <cmath>

#include "core/render/camera_rays.h"

namespace etalon {

RenderedImage make_output_image(const Scene& scene, const RenderSettings& settings,
                                const Rendering& rendering, const RenderStats& stats) {
    const CameraRays camera(scene.camera, settings.resolution);
    RenderedImage image{settings.resolution.x,   settings.resolution.y,   rendering.film.window(),
                        rendering.film.pixels(), settings.display_colors, {}};
    image.keep_display_values = settings.keep_display_values;
    image.metadata = {{"software", std::string("Etalon " ETALON_VERSION)},
                      {"backend", stats.backend},
                      {"integrator", stats.integrator},
                      {"samplesPerPixel", static_cast<int>(std::lround(rendering.samples))},
                      {"seed", fmt::format("{}", stats.seed)},
                      {"renderTimeSeconds", static_cast<float>(stats.render.wall)},
                      {"worldToCamera", Imath::M44f(camera.world_to_camera())},
                      {"worldToNDC", Imath::M44f(camera.world_to_ndc())}};
    return image;
}

}  // namespace etalon
