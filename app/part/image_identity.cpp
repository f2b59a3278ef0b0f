#include "app/part/image_identity.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/common/backends.h"
#include "app/common/program_facts.h"
#include "app/common/shallow_json.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

Json pair_json(const Imath::V2i& v) {
    return {v.x, v.y};
}

Json window_json(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

Json filter_json(const PixelFilter& f) {
    Json shape{f.radius.x, f.radius.y};
    if (f.kind == FilterKind::gaussian) shape.push_back(f.alpha);
    if (f.kind == FilterKind::mitchell) shape.insert(shape.end(), {f.b, f.c});
    if (f.kind == FilterKind::sinc) shape.push_back(f.tau);
    for (const FilterType& type : filter_list) {
        if (type.kind == f.kind) return {std::string(type.name), shape};
    }
    return shape;
}

/// Replaces infinity, which JSON cannot express.
Json number(double value) {
    return value < infinity ? Json(value) : Json("infinite");
}

Json rules_json(const WhittedRules& rules) {
    const auto& [schlick, clamp_each_ray, normalize_camera_rays, mirror_all_glass, fixed_bias] =
        rules;
    return {schlick, clamp_each_ray, normalize_camera_rays, mirror_all_glass, fixed_bias};
}

/// Returns the backend's name in the identity; exact backends have one in common.
std::string backend_name(const RenderSettings& settings, const Geometry& geometry) {
    const Backend& chosen = chosen_backend(settings);
    const bool is_own =
        !chosen.exact && (!chosen.has_own_kernels || chosen.has_own_kernels(geometry));
    return is_own ? std::string(chosen.name) : "exact";
}

}  // namespace

/// Names all settings, so that the compiler requires a new one here: without it, samples of
/// different images could be merged.
Json image_identity(const SceneArguments& arguments, std::uint64_t scene, const Scene& loaded,
                    const RenderSettings& settings) {
    const LoadOptions& options = arguments.options;
    const auto& [resolution, crop, filter, max_sample_luminance, film_scale, variance,
                 display_colors, keep_display_values, samples_per_pixel, pixel_rays, sampler, seed,
                 part, parts, target_error, integrator, max_depth, max_distance, direct_lighting,
                 sample_all_lights, roulette_threshold, whitted, backend] = settings;
    return {{"version", fmt::format("{} ({})", build_facts().version, build_facts().commit)},
            {"scene", fmt::format("{:016x}", scene)},
            {"format", loaded.format},
            {"legacy", arguments.legacy},
            {"frame", options.frame},
            {"one-sided", options.one_sided},
            {"resolution", pair_json(resolution)},
            {"crop", window_json(settings.window())},
            {"filter", filter_json(filter)},
            {"largest luminance of a sample", number(max_sample_luminance)},
            {"film scale", film_scale},
            {"display values", Json{display_colors, keep_display_values}},
            {"variance", variance},
            {"spp", samples_per_pixel},
            {"rays of a pixel", pixel_rays},
            {"sampler", sampler == Sampler::random ? "random" : "sobol"},
            {"seed", seed},
            {"part", Json{part, parts}},
            {"target-error", target_error},
            {"integrator", integrator},
            {"max-depth", max_depth},
            {"max-distance", number(max_distance)},
            {"lights", Json{direct_lighting, sample_all_lights, roulette_threshold}},
            {"rules of whitted", rules_json(whitted)},
            {"backend", backend_name(settings, loaded.geometry)}};
}

std::string identity_difference(const Json& identity, const Json& other, std::string_view where) {
    std::string text;
    for (const auto& [name, value] : other.items()) {
        const Json own = identity.contains(name) ? identity[name] : Json();
        if (own == value) continue;
        text += fmt::format("{}{} is {}, {} {}", text.empty() ? "" : "; ", name, own.dump(), where,
                            value.dump());
    }
    return text;
}

RenderSettings film_settings(const Json& identity) {
    RenderSettings s;
    const auto size = [&](int i) { return whole_number<int>(identity.at("resolution").at(i)); };
    const auto crop = [&](int i) { return whole_number<int>(identity.at("crop").at(i)); };
    const Json &filter = identity.at("filter"), &values = identity.at("display values");
    s.resolution = {size(0), size(1)};
    s.crop = {{crop(0), crop(1)}, {std::max(crop(2), 0) - 1, std::max(crop(3), 0) - 1}};
    const std::string name = filter.at(0);
    for (const FilterType& type : filter_list) {
        if (type.name == name) s.filter.kind = type.kind;
    }
    s.filter.radius = {filter.at(1).at(0), filter.at(1).at(1)};
    s.display_colors = values.at(0);
    s.keep_display_values = values.at(1);
    return s;
}

}  // namespace etalon
