// Film, sampler and integrator of a frame.
#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {
namespace {

/// Size of the largest image, as on the command line.
constexpr int most_pixels = 65536;

/// Longest path. Between white walls no path ends earlier, and the paths of a batch cannot be
/// interrupted.
constexpr int most_vertices = 1 << 14;

void build_film(SceneBuilder& b) {
    const Plugin& film = b.frame.film;
    const Parameters& p = film.parameters;
    RenderSettings& to = b.result.settings;
    to.resolution = {p.integer("xresolution"), p.integer("yresolution")};
    for (int k = 0; k < 2; ++k) {
        if (to.resolution[k] >= 1 && to.resolution[k] <= most_pixels) continue;
        b.warn(film.where, "film", "resolution {}: expected 1 to {}; taken as 256",
               to.resolution[k], most_pixels);
        to.resolution[k] = 256;
    }
    to.film_scale = p.number("scale");
    to.max_sample_luminance = p.number("maxsampleluminance");
    const std::span<const float> crop = p.numbers("cropwindow");
    if (!p.is_given("cropwindow") || crop.size() != 4) return;
    const auto place = [](float part, int size) {
        return static_cast<int>(std::ceil(static_cast<float>(size) * std::clamp(part, 0.0F, 1.0F)));
    };
    const Imath::V2i& size = to.resolution;
    const Imath::Box2i window(
        {place(std::min(crop[0], crop[1]), size.x), place(std::min(crop[2], crop[3]), size.y)},
        {place(std::max(crop[0], crop[1]), size.x) - 1,
         place(std::max(crop[2], crop[3]), size.y) - 1});
    if (window.isEmpty()) {
        b.warn(film.where, "film", "cropwindow left out: it has no pixels");
    } else {
        to.crop = window;
    }
}

/// Replaces parameters with which no sample would have a weight, and the image would be black.
void check_weights(SceneBuilder& b, PixelFilter& filter) {
    const auto replace = [&](std::string_view name, double& value, double usual) {
        b.warn(b.frame.filter.where, "filter", "{} {}: expected a number above 0; taken as {}",
               name, value, usual);
        value = usual;
    };
    if (!(filter.alpha > 0)) replace("alpha", filter.alpha, PixelFilter().alpha);
    if (filter.tau == 0) replace("tau", filter.tau, PixelFilter().tau);
}

void build_filter(SceneBuilder& b) {
    const Plugin& plugin = b.frame.filter;
    const Parameters& p = plugin.parameters;
    PixelFilter& filter = b.result.settings.filter;
    filter.kind = std::ranges::find(filter_list, plugin.type->name, &FilterType::name)->kind;
    const auto given = [&](std::string_view name, double& value) {
        if (plugin.type->find(name) != nullptr) value = p.number(name);
    };
    given("xwidth", filter.radius.x);
    given("ywidth", filter.radius.y);
    given("alpha", filter.alpha);
    given("B", filter.b);
    given("C", filter.c);
    given("tau", filter.tau);
    check_weights(b, filter);
    for (int k = 0; k < 2; ++k) {
        double& radius = filter.radius[k];
        if (radius > 0 && radius <= max_filter_radius) continue;
        b.warn(plugin.where, "filter",
               "width {}: expected a number above 0, at most {}; taken as {}", radius,
               max_filter_radius, 0.5);
        radius = 0.5;
    }
}

/// Restricts the image to an integrator's pixel bounds.
void build_pixel_bounds(SceneBuilder& b) {
    const Plugin& plugin = b.frame.integrator;
    if (plugin.type->find("pixelbounds") == nullptr) return;
    const std::span<const std::int32_t> given = plugin.parameters.integers("pixelbounds");
    if (given.size() != 4) return;
    RenderSettings& to = b.result.settings;
    const Imath::Box2i whole = to.window();
    const auto [left, right] = std::minmax(given[0], given[1]);
    const auto [top, bottom] = std::minmax(given[2], given[3]);
    const Imath::Box2i window({std::max(whole.min.x, left), std::max(whole.min.y, top)},
                              {std::min(whole.max.x, std::max(right, 0) - 1),
                               std::min(whole.max.y, std::max(bottom, 0) - 1)});
    if (window.isEmpty()) {
        b.warn(plugin.where, "film", "pixelbounds left out: they hold no pixel");
    } else {
        to.crop = window;
    }
}

/// Returns the number, or the nearest valid one after a warning.
int within(SceneBuilder& b, const Plugin& plugin, std::string_view what, std::int64_t number,
           int least, int most) {
    const auto nearest = static_cast<int>(std::clamp<std::int64_t>(number, least, most));
    if (nearest != number) {
        b.warn(plugin.where, "range", "{} {}: expected {} to {}; taken as {}", number, what, least,
               most, nearest);
    }
    return nearest;
}

void build_sampler(SceneBuilder& b) {
    const Plugin& sampler = b.frame.sampler;
    const Parameters& p = sampler.parameters;
    const bool stratified = sampler.type->name == "stratified";
    const std::int64_t samples = stratified
                                     ? std::int64_t{p.integer("xsamples")} * p.integer("ysamples")
                                     : p.integer("pixelsamples");
    b.result.settings.samples_per_pixel =
        within(b, sampler, "samples a pixel", samples, 1, 1 << 24);
    if (sampler.type->name == "random") b.result.settings.sampler = Sampler::random;
}

/// Integrators that see light only from lights, and in mirrors and glass.
bool is_direct(std::string_view name) {
    return name == "directlighting" || name == "whitted";
}

/// Integrators that handle media, and surfaces without a material in front of lights.
bool sees_media(std::string_view name) {
    return name == "volpath" || name == "bdpt" || name == "mlt";
}

bool samples_all_lights(const Plugin& integrator) {
    return is_direct(integrator.type->name) && !(integrator.type->find("strategy") &&
                                                 integrator.parameters.string("strategy") == "one");
}

void build_integrator(SceneBuilder& b) {
    const Plugin& integrator = b.frame.integrator;
    const Parameters& p = integrator.parameters;
    RenderSettings& to = b.result.settings;
    const std::string_view name = integrator.type->name;
    if (name == "ambientocclusion") {
        to.integrator = "ao";
        return;
    }
    if (b.integrator.empty()) warn_of_stand_in(b, integrator);
    to.integrator = sees_media(name) ? "volpath" : "path";
    to.direct_lighting = is_direct(name);
    to.sample_all_lights = samples_all_lights(integrator);
    const int vertices =
        within(b, integrator, "as maxdepth", p.integer("maxdepth"), 0, most_vertices);
    to.max_depth = 1 + (to.direct_lighting ? std::max(vertices, 1) : vertices);
    if (integrator.type->find("rrthreshold") != nullptr) {
        to.roulette_threshold = p.number("rrthreshold");
    }
}

}  // namespace

int light_samples(const SceneBuilder& b, const Parameters& light) {
    constexpr int most = 1024;
    return b.frame.integrator.type->name == "directlighting"
               ? std::clamp(light.integer("samples"), 1, most)
               : 1;
}

void build_settings(SceneBuilder& b) {
    build_film(b);
    build_filter(b);
    build_sampler(b);
    build_pixel_bounds(b);
    build_integrator(b);
}

}  // namespace etalon::pbrt
