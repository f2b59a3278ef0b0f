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
    const auto along = [&](float a) {
        return a == 0 ? 1.0F : static_cast<float>(std::exp(-a * distance));
    };
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
    any_random_ = std::ranges::any_of(lights_, &LightSamples::is_random);
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
    set_direct(level, batch, counts);
    if (depth < max_depth_) add_secondary(tree, depth, batch, counts);
    for (std::size_t j = 0; j < surfaces.size(); ++j) {
        colors[surfaces.traits[j].ray] = level.colors[j].color();
    }
    if (any_absorbs_ && depth > 1) absorb(level, batch, colors);
    if (!rules_.clamp_each_ray) return;
    for (Color& color : colors) color = clamped(color);
}

/// Attenuates the radiance of surfaces by the media behind which they are seen: none of a camera
/// ray, which begins outside of all.
void Whitted::absorb(const RayTree::Level& level, const RayBatch& batch, std::span<Color> colors) {
    for (std::size_t j = 0; j < level.surfaces.size(); ++j) {
        const std::uint32_t ray = level.surfaces.traits[j].ray;
        const Color& absorption = batch.paths[ray].absorption;
        if (is_black(absorption)) continue;
        colors[ray] *= transmittance(absorption, level.hits[ray].t);
    }
}

/// Intersects the rays with the scene. Sets the colours of rays that miss.
void Whitted::find_surfaces(RayTree::Level& level, const RayBatch& batch,
                            std::span<Color> colors) const {
    level.hits.resize(batch.rays.size());
    intersector_.closest(batch.rays, level.hits);
    level.surfaces.find(scene_, batch.rays, level.hits);
    if (level.surfaces.size() < batch.rays.size()) {
        environment_.set_radiance(batch.rays.directions, level.hits, colors);
    }
}

/// Finds the names of the surfaces' choices if there are any to make.
void Whitted::name_vertices(RayTree::Level& level, const RayBatch& batch) const {
    if (!any_random_) return;
    level.vertices.clear();
    for (std::size_t j = 0; j < level.surfaces.size(); ++j) {
        const RayPath& path = batch.paths[level.surfaces.traits[j].ray];
        batch.sources[path.sample].add_vertex(path.name, level.vertices);
    }
}

/// Finds point number k of the light for each surface.
void Whitted::find_light_points(std::size_t light, int k, RayTree::Level& level) const {
    const LightSamples& samples = lights_[light];
    level.light_points.is_one = !samples.is_random();
    if (level.light_points.is_one) {
        level.light_points.one = samples.position(k);
        return;
    }
    level.light_points.each.make_room(level.surfaces.size());
    level.light_samples.name(level.vertices, light_choice(light), k, samples.count());
    samples.find_positions(level.light_samples.make(sampler_), level.light_points.each);
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
        last = shadow.first_from(run.last);
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
    std::size_t arriving = 0;
    reflect_light(level, [&](std::size_t j, const PaddedColor& reflected) {
        ++arriving;
        add(j, reflected);
    });
    counts.shadow_blocked += shadow.size() - arriving;
}

/// Sets the surfaces' colours to what they send back without secondary rays. Those without a
/// diffuse or specular term have no direct light.
void Whitted::set_direct(RayTree::Level& level, const RayBatch& batch, RayCounts& counts) const {
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
    combine_direct(level);
}

/// Sets the surfaces' colours to the ambient term and the direct light.
void Whitted::combine_direct(RayTree::Level& level) {
    level.colors.resize(level.surfaces.size());
    for (const SeenSurfaces::MaterialRun& run : level.surfaces.runs) {
        const PaddedColor ambient(run.material->ambient);
        const bool is_lit = level.surfaces.scatters[run.first] > 0;
        for (std::size_t j = run.first; j < run.last; ++j) {
            level.colors[j] = ambient;
            if (is_lit) level.colors[j] += level.lit[j];
        }
    }
}

/// Adds the radiance that rays mirrored and refracted by the surfaces bring back.
void Whitted::add_secondary(RayTree& tree, int depth, const RayBatch& batch,
                            RayCounts& counts) const {
    RayTree::Level& level = tree.level(depth);
    SecondaryRays& secondary = level.secondary;
    secondary.find(level.surfaces, batch.paths, rules_, any_random_, counts);
    const std::size_t all = secondary.count;
    RayStream rays = secondary.rays.view(all);
    take_traits(batch.rays, level.surfaces, secondary.surfaces, rays, level.secondary_times);
    level.incoming.resize(all);
    for (std::size_t first = 0; first < all; first += batch_size) {
        const std::size_t count = std::min(batch_size, all - first);
        trace(
            tree, depth + 1,
            {rays.subspan(first, count), std::span(&secondary.paths[first], count), batch.sources},
            std::span(level.incoming).subspan(first, count), counts);
    }
    if (all == 0) return;
    level.lit.assign(level.surfaces.size(), {});
    for (std::size_t i = 0; i < all; ++i) {
        level.lit[secondary.surfaces[i]] += secondary.weights[i] * PaddedColor(level.incoming[i]);
    }
    for (std::size_t j = 0; j < level.lit.size(); ++j) level.colors[j] += level.lit[j];
}

}  // namespace etalon
