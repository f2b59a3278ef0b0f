#include "core/render/features.h"

#include <algorithm>
#include <limits>

#include "core/intersect/kernels.h"
#include "core/render/camera_sampler.h"
#include "core/render/tiles.h"
#include "core/shading/physical_shading.h"
#include "core/shading/surface_interaction.h"

namespace etalon {
namespace {

constexpr int most_samples = 16;

/// Calls visit(x, y, number in rows) for every pixel, on all threads. Returns false if stopped.
template <class Visit>
bool visit_pixels(const Imath::Box2i& window, const std::atomic<bool>* stop, const Visit& visit) {
    const auto stopped = [&] { return stop != nullptr && stop->load(); };
    const std::size_t width = static_cast<std::size_t>(window.size().x) + 1;
    for_each_tile(tiles_of(window), stopped, [&](std::size_t, const Imath::Box2i& tile) {
        for_each_pixel(tile, stopped, [&](int x, int y) {
            visit(x, y, (y - window.min.y) * width + (x - window.min.x));
        });
    });
    return !stopped();
}

std::size_t pixels_of(const Imath::Box2i& window) {
    const Imath::V2i last = window.size();
    return (last.x + std::size_t{1}) * (last.y + std::size_t{1});
}

/// Returns the ray through the centre of a pixel and of the lens.
Ray centre_ray(const CameraRays& camera, int x, int y) {
    return camera.ray(Vec2(x + 0.5, y + 0.5), Vec2(0.5));
}

Color shares(const Color& c) {
    const auto share = [](float x) { return std::clamp(x, 0.0F, 1.0F); };
    return {share(c.x), share(c.y), share(c.z)};
}

Color albedo_of(const Material& m) {
    return shares(m.diffuse + m.reflection + m.transmission);
}

/// Returns the albedo of a surface of either look.
Color albedo_at(const Scene& scene, const PhysicalShading* shading, const Ray& ray, const Hit& hit,
                const SurfaceInteraction& surface) {
    if (!scene.is_physical()) return albedo_of(*surface.material);
    if (shading == nullptr) return Color(0);
    LazyStorage<LobeList> room;
    const auto [frame, lobes] = shading->scattering(physical_surface(scene, ray, hit), room);
    return shares(BsdfFrom(frame, lobes, -normalized(ray.direction)).albedo());
}

/// Returns the hit of the first surface that path tracers show: not that of one of the null
/// material. `closest` finds the hit of a ray.
template <class Closest>
std::optional<Hit> first_shown(const Scene& scene, const Ray& ray, const Closest& closest) {
    std::optional<Hit> hit = closest(ray);
    for (Ray rest = ray; hit && scene.is_physical(); hit = closest(rest)) {
        const PhysicalSurface at = physical_surface(scene, rest, *hit);
        if (!has_null_material(scene, at)) break;
        rest = ray_beyond(rest, *hit, at.point.convexity);
    }
    return hit;
}

/// Returns the format's surface coordinates at a hit.
Parametrization coordinates_at(const Scene& scene, const Ray& ray, const Hit& hit) {
    return scene.is_physical() ? physical_parametrization(scene, physical_surface(scene, ray, hit))
                               : parametrization(scene, surface_interaction(scene, ray, hit));
}

}  // namespace

std::optional<SurfaceMeans> surface_means(const Scene& scene, const Intersector& intersector,
                                          const RenderSettings& settings,
                                          const PhysicalShading* shading,
                                          const std::atomic<bool>* stop) {
    const CameraSampler rays(scene.camera, settings);
    const Imath::Box2i window = rays.sampled(settings.window());
    const int samples = std::clamp(settings.samples_per_pixel, 1, most_samples);
    SurfaceMeans means{Film(window), Film(window)};
    const auto closest = [&](const Ray& ray) { return intersector.closest(ray); };
    const auto add = [&](int x, int y, const Ray& ray, bool is_seen) {
        const std::optional<Hit> hit = is_seen ? first_shown(scene, ray, closest) : std::nullopt;
        if (!hit) return means.albedo.add(x, y, Color(0)), means.normal.add(x, y, Color(0));
        const SurfaceInteraction at = surface_interaction(scene, ray, *hit);
        means.albedo.add(x, y, albedo_at(scene, shading, ray, *hit, at));
        means.normal.add(x, y, Color(at.ns));
    };
    const bool complete = visit_pixels(window, stop, [&](int x, int y, std::size_t) {
        CameraBatch of_pixel(rays);
        of_pixel.add(x, y, 0, samples);
        const CameraSamples of_image = of_pixel.make(false);
        for (std::size_t i = 0; i < of_image.rays.size(); ++i) {
            add(x, y, of_image.rays[i], of_image.weights.empty() || of_image.weights[i] > 0);
        }
    });
    if (!complete) return std::nullopt;
    if (rays.shares_corners()) means = {means.albedo.cells(), means.normal.cells()};
    return means;
}

std::optional<CentreHits> centre_hits(const Scene& scene, const Intersector& intersector,
                                      const RenderSettings& settings,
                                      const std::atomic<bool>* stop) {
    const CameraRays camera(scene.camera, settings.resolution);
    const Imath::Box2i window = settings.window();
    const std::size_t pixels = pixels_of(window);
    constexpr float never = std::numeric_limits<float>::infinity();
    CentreHits hits{std::vector(pixels, Vec3f(0)), std::vector(pixels, never),
                    std::vector(pixels, no_index), std::vector(pixels, no_index),
                    std::vector(pixels, TraversalCost())};
    const auto trace = [&](int x, int y, std::size_t pixel) {
        const Ray ray = centre_ray(camera, x, y);
        const auto closest = [&](const Ray& part) {
            return intersector.closest(part, hits.costs[pixel]);
        };
        const std::optional<Hit> hit = first_shown(scene, ray, closest);
        if (!hit) return;
        const Vec3 position = surface_at(scene.geometry, ray, *hit).position;
        hits.positions[pixel] = Vec3f(position);
        hits.depths[pixel] = static_cast<float>(camera.depth(position));
        hits.primitives[pixel] = hit->primitive;
        hits.instances[pixel] = hit->instance;
    };
    if (!visit_pixels(window, stop, trace)) return std::nullopt;
    return hits;
}

std::optional<CentreParametrizations> centre_parametrizations(const Scene& scene,
                                                              const Intersector& intersector,
                                                              const RenderSettings& settings,
                                                              const std::atomic<bool>* stop) {
    const CameraRays camera(scene.camera, settings.resolution);
    const Imath::Box2i window = settings.window();
    const std::size_t pixels = pixels_of(window);
    CentreParametrizations result{std::vector(pixels, Imath::V2f(0)), std::vector(pixels, Vec3f(0)),
                                  std::vector(pixels, Vec3f(0))};
    const auto closest = [&](const Ray& ray) { return intersector.closest(ray); };
    const auto trace = [&](int x, int y, std::size_t pixel) {
        const Ray ray = centre_ray(camera, x, y);
        const std::optional<Hit> hit = first_shown(scene, ray, closest);
        if (!hit) return;
        const Parametrization at = coordinates_at(scene, ray, *hit);
        result.uv[pixel] = Imath::V2f(at.uv);
        result.dpdu[pixel] = Vec3f(at.dpdu);
        result.dpdv[pixel] = Vec3f(at.dpdv);
    };
    if (!visit_pixels(window, stop, trace)) return std::nullopt;
    return result;
}

}  // namespace etalon
