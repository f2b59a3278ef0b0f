#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/backends.h"
#include "app/render/aovs.h"
#include "app/render/arguments.h"
#include "core/image/io.h"
#include "core/render/spd_rules.h"

namespace etalon {
namespace {

constexpr int max_picture_side = 65536;

/// Of each pixel, where it is an error or a time that ends a picture.
constexpr int ample_samples = 1 << 16;

std::string apply_resolution(const std::string& text, Camera& camera) {
    if (text.empty()) return {};
    int width = 0, height = 0;
    char rest = 0;
    const bool parsed = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    if (!parsed || width < 1 || height < 1 || std::max(width, height) > max_picture_side) {
        return "--resolution " + text + ": expected WIDTHxHEIGHT, e.g. 640x480";
    }
    camera.width = width;
    camera.height = height;
    return {};
}

std::string apply_crop(const std::string& text, const Camera& camera, Imath::Box2i& window) {
    window = {{0, 0}, {camera.width - 1, camera.height - 1}};
    if (text.empty()) return {};
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    char rest = 0;
    const bool parsed = std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &x0, &y0, &x1, &y1, &rest) == 4;
    const bool inside =
        0 <= x0 && x0 < x1 && x1 <= camera.width && 0 <= y0 && y0 < y1 && y1 <= camera.height;
    if (!parsed || !inside) {
        return fmt::format("--crop {}: expected X0,Y0,X1,Y1 inside 0,0,{},{}", text, camera.width,
                           camera.height);
    }
    window = {{x0, y0}, {x1 - 1, y1 - 1}};
    return {};
}

/// What a deterministic picture cannot have, and a whole one need not.
void apply_samples(const RenderArguments& a, Scene& scene) {
    if (a.target_error > 0 || a.time_limit > 0) scene.samples_per_pixel = ample_samples;
    if (a.samples >= 0) scene.samples_per_pixel = a.samples;
    if (a.spd) apply_spd_rules(scene);
}

std::string check_aovs(const RenderArguments& a, const Scene& scene) {
    if (a.aovs.empty()) return {};
    if (!a.outputs.empty() && std::none_of(a.outputs.begin(), a.outputs.end(), can_hold_channels)) {
        return "--aov: no output is an EXR; expected -o FILE.exr to hold the channels";
    }
    return obstacle_to_aovs(a.aovs, *find_backend(scene.backend));
}

}  // namespace

std::string apply(const RenderArguments& a, Scene& scene, Imath::Box2i& window) {
    apply_samples(a, scene);
    if (a.max_depth > 0) scene.whitted.max_depth = a.max_depth;
    if (!a.backend.empty()) scene.backend = a.backend;
    if (scene.backend.empty()) scene.backend = "bvh";
    if (a.target_error > 0 && scene.samples_per_pixel < 1) {
        return "--target-error needs at least one sample per pixel";
    }
    std::string error = check_aovs(a, scene);
    if (error.empty()) error = apply_resolution(a.resolution, scene.camera);
    return error.empty() ? apply_crop(a.crop, scene.camera, window) : error;
}

RenderOptions render_options(const RenderArguments& a, const Scene& scene,
                             const Imath::Box2i& window) {
    RenderOptions options;
    options.samples_per_pixel = scene.samples_per_pixel;
    options.max_depth = scene.whitted.max_depth;
    options.seed = a.seed;
    if (a.sampler == "random") options.sampler = Sampler::random;
    options.window = window;
    options.error = a.target_error;
    options.variance = need_variance(a.aovs);
    if (a.time_limit > 0) options.deadline = Deadline(a.time_limit);
    return options;
}

}  // namespace etalon
