#include "core/integrators/whitted/whitted.h"

#include <algorithm>
#include <cmath>

#include "core/sampling/dimensions.h"

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
    return {along(absorption.x), along(absorption.y), along(absorption.z)};
}

/// Factor of the highlight for unit vectors; `normal` is on the light's side.
double highlight_of(const Material& m, const Vec3& direction, const Vec3& normal,
                    const Vec3& towards) {
    const double cosine = m.highlight == Highlight::phong
                              ? reflect(direction, normal).dot(towards)
                              : normal.dot(normalized(towards - direction));
    if (!(cosine > 0) && m.shininess > 0) return 0;
    return std::pow(std::max(0.0, cosine), m.shininess);
}

/// Part of a white light from `towards` that the surface sends back along the ray.
Color scattered(const Material& m, const Vec3& direction, const Vec3& normal, const Vec3& towards,
                double cosine) {
    Color sum = m.diffuse * static_cast<float>(cosine);
    if (is_black(m.specular)) return sum;
    return sum += m.specular * static_cast<float>(highlight_of(m, direction, normal, towards));
}

}  // namespace

Whitted::Whitted(const Scene& scene, const BatchIntersector& intersector,
                 const RenderSettings& settings, std::vector<std::string>& problems)
    : scene_(scene),
      intersector_(intersector),
      environment_(scene.whitted().environment, problems),
      max_depth_(settings.max_depth),
      rules_(settings.whitted) {
    for (const Light& light : scene.whitted().lights)
        lights_.emplace_back(light, settings.samples_per_pixel);
}

void Whitted::radiance(const CameraSamples& samples, std::span<Color> colors,
                       RayCounts& counts) const {
    std::vector<Path> paths;
    paths.reserve(samples.sources.size());
    for (const SampleSource& source : samples.sources) {
        paths.push_back({&source, camera_ray_name, Color(0.0F)});
    }
    counts.camera += paths.size();
    trace({samples.rays, paths}, 1, colors, counts);
    if (!rules_.normalize_camera_rays) return;
    for (Color& color : colors) color = fitted(color);
}

/// Sets the colour that each ray of the batch brings back: what the recursion over a tree of rays
/// gives for one of them, for all of a depth together.
void Whitted::trace(const RaysView& batch, int depth, std::span<Color> colors,
                    RayCounts& counts) const {
    std::vector<Hit> hits(batch.rays.size());
    const SeenSurfaces surfaces = find_surfaces(batch, hits, colors);
    (depth == 1 ? counts.camera_hits : counts.secondary_hits) += surfaces.size();
    add_direct(batch, surfaces, colors, counts);
    if (depth < max_depth_) add_secondary(batch, depth, surfaces, colors, counts);
    for (const auto& traits : surfaces.traits) {
        const Color& absorption = batch.paths[traits.ray].absorption;
        if (is_black(absorption)) continue;
        colors[traits.ray] *= transmittance(absorption, hits[traits.ray].t);
    }
    if (!rules_.clamp_each_ray) return;
    for (Color& color : colors) color = clamped(color);
}

/// Finds where the rays hit, and sets their colours to what does not depend on other rays.
SeenSurfaces Whitted::find_surfaces(const RaysView& batch, std::span<Hit> hits,
                                    std::span<Color> colors) const {
    intersector_.closest(batch.rays, hits);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].primitive != no_index) continue;
        colors[i] = environment_.radiance(batch.rays[i].direction);
    }
    SeenSurfaces surfaces(scene_, batch.rays, hits);
    for (const auto& traits : surfaces.traits) colors[traits.ray] = traits.material->ambient;
    return surfaces;
}

/// Adds what the lights send along each ray, by surfaces that scatter or shine.
void Whitted::add_direct(const RaysView& batch, const SeenSurfaces& surfaces,
                         std::span<Color> colors, RayCounts& counts) const {
    const std::size_t count = surfaces.size();
    std::vector<Color> sums(count, Color(0.0F)), reflected(count);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        std::ranges::fill(reflected, Color(0.0F));
        for (int k = 0; k < lights_[i].count(); ++k) {
            add_light(i, k, batch, surfaces, reflected, counts);
        }
        for (std::size_t j = 0; j < count; ++j) sums[j] += reflected[j] * lights_[i].color();
    }
    for (std::size_t j = 0; j < count; ++j) {
        const auto& traits = surfaces.traits[j];
        if (traits.scatters) colors[traits.ray] += sums[j];
    }
}

/// Returns the light's point k for each surface.
std::vector<Vec3> Whitted::light_points(std::size_t light, int k, const RaysView& batch,
                                        const SeenSurfaces& surfaces) const {
    const LightSamples& samples = lights_[light];
    if (!samples.is_random()) return std::vector(surfaces.size(), samples.position(k));
    PointBatch points;
    for (const auto& traits : surfaces.traits) {
        const Path& path = batch.paths[traits.ray];
        path.sample->add_stratified(light_dimension(path.name, light), k, samples.count(), points);
    }
    std::vector<Vec3> positions;
    positions.reserve(surfaces.size());
    for (const Vec2& uv : points.make()) positions.push_back(samples.position(uv));
    return positions;
}

/// Adds the part of the light's point k, taken as white, that each surface sends back.
void Whitted::add_light(std::size_t light, int k, const RaysView& batch,
                        const SeenSurfaces& surfaces, std::span<Color> reflected,
                        RayCounts& counts) const {
    ShadowRays shadow(surfaces, light_points(light, k, batch, surfaces), rules_.fixed_bias);
    for (std::size_t i = 0; i < shadow.rays.size(); ++i) {
        const std::uint32_t ray = surfaces.traits[shadow.facing[i].surface].ray;
        shadow.rays[i].traits_and_time = batch.rays[ray].traits_and_time;
    }
    std::vector<std::uint8_t> blocked(shadow.rays.size());
    intersector_.occluded(shadow.rays, blocked);
    counts.shadow += shadow.rays.size();
    for (std::size_t i = 0; i < shadow.rays.size(); ++i) {
        counts.shadow_blocked += blocked[i];
        if (blocked[i] != 0) continue;
        const auto& [j, towards, cosine] = shadow.facing[i];
        reflected[j] += scattered(*surfaces.traits[j].material, surfaces.directions[j],
                                  surfaces.shading_normals[j], towards, cosine);
    }
}

void Whitted::SecondaryRays::reserve(std::size_t count) {
    rays.reserve(count);
    paths.reserve(count);
    surfaces.reserve(count);
    weights.reserve(count);
}

/// Makes the rays that leave the surfaces. Kept out of line, so that the group of rays is not on
/// the stack once for each depth.
[[gnu::noinline]] Whitted::SecondaryRays Whitted::secondary_rays(const RaysView& batch,
                                                                 const SeenSurfaces& surfaces,
                                                                 RayCounts& counts) const {
    SecondaryRays secondary;
    secondary.reserve(surfaces.size());
    LeavingRays leaving(surfaces, {rules_.schlick, rules_.fixed_bias});
    for (std::size_t first = 0, count = 0; first < surfaces.size(); first += count) {
        count = leaving.make(first);
        for (std::size_t i = 0; i < count; ++i) {
            leave(batch, surfaces.traits[first + i], leaving, first, i, secondary, counts);
        }
    }
    return secondary;
}

/// Adds what mirrors and glass let come back.
void Whitted::add_secondary(const RaysView& batch, int depth, const SeenSurfaces& surfaces,
                            std::span<Color> colors, RayCounts& counts) const {
    const SecondaryRays secondary = secondary_rays(batch, surfaces, counts);
    std::vector<Color> sums(surfaces.size(), Color(0.0F)), incoming(secondary.rays.size());
    const RaysView all{secondary.rays, secondary.paths};
    for (std::size_t first = 0; first < incoming.size(); first += batch_size) {
        const std::size_t count = std::min(batch_size, incoming.size() - first);
        trace({all.rays.subspan(first, count), all.paths.subspan(first, count)}, depth + 1,
              std::span(incoming).subspan(first, count), counts);
    }
    for (std::size_t i = 0; i < incoming.size(); ++i) {
        sums[secondary.surfaces[i]] += secondary.weights[i] * incoming[i];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) colors[surfaces.traits[i].ray] += sums[i];
}

/// Appends the rays that leave surface number first + i: the mirrored one first.
void Whitted::leave(const RaysView& batch, const SeenSurfaces::Traits& from,
                    const LeavingRays& leaving, std::size_t first, std::size_t i, SecondaryRays& to,
                    RayCounts& counts) const {
    const Material& m = *from.material;
    if (is_black(m.reflection) && is_black(m.transmission)) return;
    const bool counted = rules_.mirror_all_glass && !is_black(m.transmission);
    Color reflection = m.reflection, transmission = m.transmission;
    if (!is_black(m.transmission)) {
        if (m.fresnel) {
            const double reflectance = leaving.reflectance(i);
            reflection *= static_cast<float>(reflectance);
            transmission *= static_cast<float>(1 - reflectance);
        }
        if (leaving.is_total(i)) transmission = Color(0.0F);
    }
    const Path& path = batch.paths[from.ray];
    const auto add = [&](const Color& weight, const Ray& ray, bool crosses, const Color& within) {
        to.surfaces.push_back(first + i);
        to.weights.push_back(weight);
        to.rays.push_back(ray);
        to.rays.back().traits_and_time = batch.rays[from.ray].traits_and_time;
        to.paths.push_back({path.sample, ray_name(path.name, crosses), within});
    };
    if (!is_black(reflection) || counted) {
        ++counts.reflected;
        add(reflection, leaving.mirrored(i), false, path.absorption);
    }
    if (!is_black(transmission)) {
        ++counts.refracted;
        const Color beyond = leaving.enters(i) ? m.absorption : Color(0.0F);
        add(transmission, leaving.refracted(i), true, beyond);
    }
}

}  // namespace etalon
