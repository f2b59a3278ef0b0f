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

std::string apply_resolution(const std::string& text, RenderSettings& settings) {
    if (text.empty()) return {};
    int width = 0, height = 0;
    char rest = 0;
    const bool parsed = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    if (!parsed || width < 1 || height < 1 || std::max(width, height) > max_picture_side) {
        return "--resolution " + text + ": expected WIDTHxHEIGHT, e.g. 640x480";
    }
    settings.resolution = {width, height};
    return {};
}

std::string apply_crop(const std::string& text, RenderSettings& settings) {
    if (text.empty()) return {};
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    char rest = 0;
    const bool parsed = std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &x0, &y0, &x1, &y1, &rest) == 4;
    const Imath::V2i& size = settings.resolution;
    const bool inside = 0 <= x0 && x0 < x1 && x1 <= size.x && 0 <= y0 && y0 < y1 && y1 <= size.y;
    if (!parsed || !inside) {
        return fmt::format("--crop {}: expected X0,Y0,X1,Y1 inside 0,0,{},{}", text, size.x,
                           size.y);
    }
    settings.crop = {{x0, y0}, {x1 - 1, y1 - 1}};
    return {};
}

/// What a deterministic picture cannot have, and a whole one need not.
void apply_samples(const RenderArguments& a, RenderSettings& settings) {
    if (a.target_error > 0 || a.time_limit > 0) settings.samples_per_pixel = ample_samples;
    if (a.samples >= 0) settings.samples_per_pixel = a.samples;
    if (a.spd) apply_spd_rules(settings);
    settings.target_error = a.target_error;
    settings.seed = a.seed;
    if (a.sampler == "random") settings.sampler = Sampler::random;
}

std::string check_aovs(const RenderArguments& a, const RenderSettings& settings) {
    if (a.aovs.empty()) return {};
    if (!a.outputs.empty() && std::none_of(a.outputs.begin(), a.outputs.end(), can_hold_channels)) {
        return "--aov: no output is an EXR; expected -o FILE.exr to hold the channels";
    }
    return obstacle_to_aovs(a.aovs, chosen_backend(settings));
}

}  // namespace

std::string apply(const RenderArguments& a, RenderSettings& settings) {
    apply_samples(a, settings);
    if (a.max_depth > 0) settings.max_depth = a.max_depth;
    if (!a.backend.empty()) settings.backend = a.backend;
    settings.variance = need_variance(a.aovs);
    if (a.target_error > 0 && settings.samples_per_pixel < 1) {
        return "--target-error needs at least one sample per pixel";
    }
    std::string error = check_aovs(a, settings);
    if (error.empty()) error = apply_resolution(a.resolution, settings);
    return error.empty() ? apply_crop(a.crop, settings) : error;
}

}  // namespace etalon
