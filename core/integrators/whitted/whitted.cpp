#include "core/integrators/whitted/whitted.h"

#include <algorithm>
#include <cmath>

#include "core/sampling/dimensions.h"
#include "core/shading/highlights.h"

namespace etalon {
namespace {

bool is_black(const Color& c) {
    return c == Color(0.0F);
}

Color clamped(const Color& c) {
    return {std::clamp(c.x, 0.0F, 1.0F), std::clamp(c.y, 0.0F, 1.0F), std::clamp(c.z, 0.0F, 1.0F)};
}

/// Scales a colour so that its largest part becomes 1, if that is above 1.
Color fitted(const Color& c) {
    return c / std::max({1.0F, c.x, c.y, c.z});
}

/// Transmittance over a distance (Beer-Lambert).
Color transmittance(const Color& absorption, double distance) {
    const auto along = [&](float a) { return static_cast<float>(std::exp(-a * distance)); };
    const float x = along(absorption.x);
    const auto like_x = [&](float a) { return a == absorption.x ? x : along(a); };
    return {x, like_x(absorption.y), like_x(absorption.z)};
}

/// Gives rays, which leave the surfaces of those numbers, the traits and times of the rays that hit
/// the surfaces. `times` must outlive the stream.
template <class Numbers>
void take_traits(const RayStream& seen_by, const SeenSurfaces& surfaces, const Numbers& numbers,
                 RayStream& rays, std::vector<ShutterTime>& times) {
    rays.traits = seen_by.traits;
    if (seen_by.times == nullptr) return;
    times.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        times.push_back(seen_by.times[surfaces.traits[numbers[i]].ray]);
    }
    rays.times = times.data();
}

}  // namespace

Whitted::Whitted(const Scene& scene, const BatchIntersector& intersector,
                 const RenderSettings& settings, std::vector<std::string>& problems)
    : scene_(scene),
      intersector_(intersector),
      environment_(scene.whitted().environment,
                   settings.display_colors ? Encoding::display : Encoding::linear, problems),
      any_absorbs_(std::ranges::any_of(scene.whitted().materials,
                                       [](const Material& m) { return !is_black(m.absorption); })),
      max_depth_(settings.max_depth),
      sampler_(settings.sampler),
      rules_(settings.whitted) {
    for (const Light& light : scene.whitted().lights)
        lights_.emplace_back(light, settings.samples_per_pixel);
}

void Whitted::radiance(const CameraSamples& samples, std::span<Color> colors,
                       RayCounts& counts) const {
    const auto loan = trees_.lend();
    RayTree& tree = *loan;
    counts.camera += samples.rays.size();
    const RayBatch batch{samples.rays, tree.camera_paths(samples.rays.size()), samples.sources};
    trace(tree, 1, batch, colors, counts);
    if (!rules_.normalize_camera_rays) return;
    for (Color& color : colors) color = fitted(color);
}

/// Sets the radiance along each ray of the batch. It is that of the usual recursion over a tree of
/// rays, evaluated for all rays of a depth together.
void Whitted::trace(RayTree& tree, int depth, const RayBatch& batch, std::span<Color> colors,
                    RayCounts& counts) const {
    RayTree::Level& level = tree.level(depth);
    find_surfaces(level, batch, colors);
    const SeenSurfaces& surfaces = level.surfaces;
    (depth == 1 ? counts.camera_hits : counts.secondary_hits) += surfaces.size();
    add_direct(level, batch, counts);
    if (depth < max_depth_) add_secondary(tree, depth, batch, counts);
    for (std::size_t j = 0; j < surfaces.size(); ++j) {
        const std::uint32_t ray = surfaces.traits[j].ray;
        colors[ray] = level.colors[j];
        if (!any_absorbs_) continue;
        const Color& absorption = batch.paths[ray].absorption;
        if (!is_black(absorption)) colors[ray] *= transmittance(absorption, level.hits[ray].t);
    }
    if (!rules_.clamp_each_ray) return;
    for (Color& color : colors) color = clamped(color);
}

/// Intersects the rays with the scene. Sets the colours of rays that miss, and starts those of
/// surfaces with the ambient term, which needs no other ray.
void Whitted::find_surfaces(RayTree::Level& level, const RayBatch& batch,
                            std::span<Color> colors) const {
    level.hits.resize(batch.rays.size());
    intersector_.closest(batch.rays, level.hits);
    environment_.set_radiance(batch.rays.directions, level.hits, colors);
    level.surfaces.find(scene_, batch.rays, level.hits);
    level.colors.resize(level.surfaces.size());
    for (const SeenSurfaces::MaterialRun& run : level.surfaces.runs) {
        std::fill_n(level.colors.begin() + static_cast<std::ptrdiff_t>(run.first),
                    run.last - run.first, run.material->ambient);
    }
}

/// Finds the names of the surfaces' choices if there are any to make.
void Whitted::name_vertices(RayTree::Level& level, const RayBatch& batch) const {
    if (std::ranges::none_of(lights_, &LightSamples::is_random)) return;
    level.vertices.clear();
    for (const auto& traits : level.surfaces.traits) {
        const RayPath& path = batch.paths[traits.ray];
        batch.sources[path.sample].add_vertex(path.name, level.vertices);
    }
}

/// Finds point number k of the light for each surface.
void Whitted::find_light_points(std::size_t light, int k, RayTree::Level& level) const {
    const LightSamples& samples = lights_[light];
    const std::size_t count = level.surfaces.size();
    level.light_points.make_room(count);
    if (!samples.is_random()) {
        const Vec3 position = samples.position(k);
        for (std::size_t j = 0; j < count; ++j) level.light_points.set(j, position);
        return;
    }
    level.light_samples.name(level.vertices, light_choice(light), k, samples.count());
    samples.find_positions(level.light_samples.make(sampler_), level.light_points);
}

/// Calls add(j, reflected) for each surface j whose shadow ray is not occluded, with the light that
/// it reflects from a white light.
template <class Add>
void Whitted::reflect_light(RayTree::Level& level, const Add& add) const {
    const ShadowRays& shadow = level.shadow;
    level.highlights.make_room(shadow.size());
    std::size_t first = 0, last = 0;
    for (const SeenSurfaces::MaterialRun& run : level.surfaces.runs) {
        first = last;
        while (last < shadow.size() && shadow.surface(last) < run.last) ++last;
        const Material& m = *run.material;
        const PaddedColor diffuse(m.diffuse), specular(m.specular);
        const auto reflect = [&](const auto& highlight) {
            for (std::size_t i = first; i < last; ++i) {
                if (shadow.blocked[i] != 0) continue;
                PaddedColor reflected = diffuse * static_cast<float>(shadow.cosines[i]);
                highlight(i, reflected);
                add(shadow.surface(i), reflected);
            }
        };
        if (is_black(m.specular)) {
            reflect([](std::size_t, const PaddedColor&) {});
        } else {
            find_highlights(m, level.surfaces, shadow, first, last, level.highlights);
            reflect(
                [&](std::size_t i, PaddedColor& sum) { sum += specular * level.highlights[i]; });
        }
    }
}

/// Calls add(j, reflected) for each surface j that point k of the light illuminates, with the light
/// that it reflects if the point is white.
template <class Add>
void Whitted::add_light(std::size_t light, int k, RayTree::Level& level, const RayBatch& batch,
                        RayCounts& counts, const Add& add) const {
    find_light_points(light, k, level);
    const SeenSurfaces& surfaces = level.surfaces;
    ShadowRays& shadow = level.shadow;
    shadow.aim(surfaces, level.light_points, rules_.fixed_bias);
    RayStream rays = shadow.rays();
    take_traits(batch.rays, surfaces, shadow.surfaces.values, rays, level.shadow_times);
    intersector_.occluded(rays, shadow.blocked);
    counts.shadow += shadow.size();
    counts.shadow_blocked += std::ranges::count(shadow.blocked, 1);
    reflect_light(level, add);
}

/// Adds the direct light of surfaces with a diffuse or specular term.
void Whitted::add_direct(RayTree::Level& level, const RayBatch& batch, RayCounts& counts) const {
    const std::size_t count = level.surfaces.size();
    level.lit.assign(count, {});
    name_vertices(level, batch);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const PaddedColor color(lights_[i].color());
        if (lights_[i].count() == 1) {
            add_light(i, 0, level, batch, counts, [&](std::size_t j, const PaddedColor& sent) {
                level.lit[j] += sent * color;
            });
            continue;
        }
        level.reflected.assign(count, {});
        for (int k = 0; k < lights_[i].count(); ++k) {
            add_light(i, k, level, batch, counts,
                      [&](std::size_t j, const PaddedColor& sent) { level.reflected[j] += sent; });
        }
        for (std::size_t j = 0; j < count; ++j) level.lit[j] += level.reflected[j] * color;
    }
    for (std::size_t j = 0; j < count; ++j) {
        if (level.surfaces.scatters[j] > 0) level.colors[j] += level.lit[j].color();
    }
}

/// Adds the radiance that rays mirrored and refracted by the surfaces bring back.
void Whitted::add_secondary(RayTree& tree, int depth, const RayBatch& batch,
                            RayCounts& counts) const {
    RayTree::Level& level = tree.level(depth);
    SecondaryRays& secondary = level.secondary;
    secondary.find(level.surfaces, batch.paths, rules_, counts);
    const std::size_t all = secondary.paths.size();
    RayStream rays = secondary.rays.view(all);
    take_traits(batch.rays, level.surfaces, secondary.surfaces, rays, level.secondary_times);
    level.incoming.resize(all);
    for (std::size_t first = 0; first < all; first += batch_size) {
        const std::size_t count = std::min(batch_size, all - first);
        trace(tree, depth + 1,
              {rays.subspan(first, count), std::span(secondary.paths).subspan(first, count),
               batch.sources},
              std::span(level.incoming).subspan(first, count), counts);
    }
    if (all == 0) return;
    level.lit.assign(level.surfaces.size(), {});
    for (std::size_t i = 0; i < all; ++i) {
        level.lit[secondary.surfaces[i]] += PaddedColor(secondary.weights[i] * level.incoming[i]);
    }
    for (std::size_t j = 0; j < level.lit.size(); ++j) level.colors[j] += level.lit[j].color();
}

}  // namespace etalon
