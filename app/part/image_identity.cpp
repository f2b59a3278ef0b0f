#include "app/part/image_identity.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/common/backends.h"
#include "app/common/program_facts.h"
#include "app/common/shallow_json.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

Json pair(const Imath::V2i& v) {
    return {v.x, v.y};
}

Json window(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

Json filter(const PixelFilter& f) {
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

Json whitted_rules(const WhittedRules& r) {
    return {r.schlick, r.clamp_each_ray, r.normalize_camera_rays, r.mirror_all_glass, r.fixed_bias};
}

/// Returns the backend's name in the identity; exact backends have one in common.
std::string backend(const RenderSettings& settings, const Geometry& geometry) {
    const Backend& chosen = chosen_backend(settings);
    const bool is_own =
        !chosen.exact && (!chosen.has_own_kernels || chosen.has_own_kernels(geometry));
    return is_own ? std::string(chosen.name) : "exact";
}

}  // namespace

Json image_identity(const SceneArguments& arguments, std::uint64_t scene, const Scene& loaded,
                    const RenderSettings& s) {
    const LoadOptions& options = arguments.options;
    return {{"version", fmt::format("{} ({})", build_facts().version, build_facts().commit)},
            {"scene", fmt::format("{:016x}", scene)},
            {"format", loaded.format},
            {"legacy", arguments.legacy},
            {"frame", options.frame},
            {"one-sided", options.one_sided},
            {"resolution", pair(s.resolution)},
            {"crop", window(s.window())},
            {"filter", filter(s.filter)},
            {"largest luminance of a sample", number(s.max_sample_luminance)},
            {"film scale", s.film_scale},
            {"display values", Json{s.display_colors, s.keep_display_values}},
            {"variance", s.variance},
            {"spp", s.samples_per_pixel},
            {"rays of a pixel", s.pixel_rays},
            {"sampler", s.sampler == Sampler::random ? "random" : "sobol"},
            {"seed", s.seed},
            {"part", Json{s.part, s.parts}},
            {"target-error", s.target_error},
            {"integrator", s.integrator},
            {"max-depth", s.max_depth},
            {"max-distance", number(s.max_distance)},
            {"lights", Json{s.direct_lighting, s.sample_all_lights, s.roulette_threshold}},
            {"rules of whitted", whitted_rules(s.whitted)},
            {"backend", backend(s, loaded.geometry)}};
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
