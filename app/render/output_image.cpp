#include "app/render/output_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>

#include "app/common/program_facts.h"
#include "core/render/camera_frame.h"
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

/// Returns the width of a pixel over its height; 1 if the projection has no such.
double pixel_aspect(const Camera& camera, const Imath::V2i& resolution) {
    constexpr double rounding = 1e-6;
    const CameraFrame frame = camera_frame(camera, resolution);
    if (frame.projection == Projection::environment) return 1;
    const Vec2 size = frame.pixel_size * Vec2(frame.u.length(), frame.v.length());
    const double aspect = std::abs(size.x / size.y);
    const bool is_other = std::isfinite(aspect) && aspect > 0 && std::abs(aspect - 1) > rounding;
    return is_other ? aspect : 1;
}

/// Adds a matrix, unless floats cannot hold it.
void add(const char* name, const Imath::M44d& matrix, RenderedImage& image) {
    const Imath::M44f stored(matrix);
    const std::span<const float> elements(stored[0], 16);
    if (!std::ranges::all_of(elements, [](float x) { return std::isfinite(x); })) return;
    image.metadata[name] = stored;
}

/// Returns a text with U+FFFD in place of bytes that are not UTF-8, as in JSON.
std::string as_utf8(const std::string& text) {
    using Json = nlohmann::json;
    return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
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
                      {"scene", as_utf8(std::filesystem::path(stats.scene).filename())},
                      {"integrator", stats.integrator},
                      {"samplesPerPixel", static_cast<float>(rendering.samples)},
                      {"seed", fmt::format("{}", stats.seed)}};
    add("worldToCamera", camera.world_to_camera(), image);
    if (camera.world_to_ndc()) add("worldToNDC", *camera.world_to_ndc(), image);
    if (const double aspect = pixel_aspect(scene.camera, settings.resolution); aspect != 1) {
        image.metadata["pixelAspectRatio"] = static_cast<float>(aspect);  // of OpenEXR
    }
    add_what_was_reached(stats, image);
    return image;
}

}  // namespace etalon
