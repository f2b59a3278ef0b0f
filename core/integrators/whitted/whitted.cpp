#include "core/integrators/whitted/whitted.h"

#include <algorithm>
#include <cmath>

#include "core/sampling/dimensions.h"
#include "core/shading/fresnel.h"

namespace etalon {
namespace {

/// A light's own place is not part of the way to it: what lies within this part of the distance
/// casts no shadow, so that a light may lie on a surface. Well above the roundings of a double.
constexpr double shadow_end = 1 - 0x1p-32;

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
    return std::pow(std::max(0.0, cosine), m.shininess);
}

}  // namespace

Whitted::Whitted(const Scene& scene, const Intersector& intersector, const RenderSettings& settings,
                 std::vector<std::string>& problems)
    : scene_(scene),
      intersector_(intersector),
      environment_(scene.look.environment, problems),
      max_depth_(settings.max_depth),
      rules_(settings.whitted) {
    for (const Light& light : scene.look.lights)
        lights_.emplace_back(light, settings.samples_per_pixel);
}

Color Whitted::radiance(const Ray& camera_ray, const SampleSource& sample,
                        RayCounts& counts) const {
    Context context{sample, counts};
    ++counts.camera;
    const std::optional<Hit> hit = intersector_.closest(camera_ray);
    if (hit) ++counts.camera_hits;
    const Color color = trace({camera_ray, 1, camera_ray_name, Color(0.0F)}, hit, context);
    return rules_.normalize_camera_rays ? fitted(color) : color;
}

Color Whitted::trace(const Path& path, std::optional<Hit> hit, Context& context) const {
    Color color;
    if (hit) {
        const SurfaceInteraction at = surface_interaction(scene_, path.ray, *hit);
        color = at.material.ambient + direct(path, at, context);
        if (path.depth < max_depth_) color += secondary(path, at, context);
        if (!is_black(path.absorption)) color *= transmittance(path.absorption, hit->t);
    } else {
        color = environment_.radiance(path.ray.direction);
    }
    return rules_.clamp_each_ray ? clamped(color) : color;
}

Color Whitted::direct(const Path& path, const SurfaceInteraction& at, Context& context) const {
    Color sum(0.0F);
    if (is_black(at.material.diffuse) && is_black(at.material.specular)) return sum;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const LightSamples& light = lights_[i];
        const std::uint32_t dimension = light_dimension(path.name, i);
        Color reflected(0.0F);
        for (int k = 0; k < light.count(); ++k) {
            const Vec3 position = light.position(k, context.sample, dimension);
            reflected += lit_by(position, path, at, context);
        }
        sum += reflected * light.color();
    }
    return sum;
}

/// The part of a white point light's colour that the surface sends back along the ray.
Color Whitted::lit_by(const Vec3& light, const Path& path, const SurfaceInteraction& at,
                      Context& context) const {
    const Vec3 towards = normalized(light - at.surface.position);
    const double cosine = at.ns.dot(towards);
    if (!(cosine > 0) || !(at.ng.dot(towards) > 0)) return Color(0.0F);

    Ray shadow = spawn_ray_to(at.surface, light);
    if (rules_.fixed_bias != 0) {
        shadow = leave(at, towards, false);
        shadow.direction = light - shadow.origin;
    }
    shadow.tmax = shadow_end;
    shadow.coherent = path.ray.coherent;
    ++context.counts.shadow;
    if (intersector_.occluded(shadow)) {
        ++context.counts.shadow_blocked;
        return Color(0.0F);
    }
    Color reflected = at.material.diffuse * static_cast<float>(cosine);
    if (!is_black(at.material.specular)) {
        const double highlight = highlight_of(at.material, path.ray.direction, at.ns, towards);
        reflected += at.material.specular * static_cast<float>(highlight);
    }
    return reflected;
}

Color Whitted::secondary(const Path& path, const SurfaceInteraction& at, Context& context) const {
    const Material& m = at.material;
    const Vec3& direction = path.ray.direction;
    Color reflection = m.reflection, transmission = m.transmission;
    const Vec3& normal = direction.dot(at.ns) < 0 ? at.ns : at.ng;
    const double cosine = std::clamp(-direction.dot(normal), 0.0, 1.0);
    const double eta = at.entering ? 1 / m.ior : m.ior;
    Vec3 refracted;
    if (!is_black(m.transmission)) {
        const FresnelTerms fresnel =
            rules_.schlick ? fresnel_schlick(eta, cosine) : fresnel_dielectric(eta, cosine);
        if (m.fresnel) {
            reflection *= static_cast<float>(fresnel.reflectance);
            transmission *= static_cast<float>(1 - fresnel.reflectance);
        }
        if (fresnel.total) transmission = Color(0.0F);
        refracted = normalized(refract(direction, normal, eta, cosine, fresnel.cos_refracted));
    }
    Color sum(0.0F);
    const bool counted = rules_.mirror_all_glass && !is_black(m.transmission);
    if (!is_black(reflection) || counted) {
        ++context.counts.reflected;
        const Vec3 mirrored = normalized(reflect(direction, normal));
        sum += reflection * follow(path, at, mirrored, !at.entering, context);
    }
    if (!is_black(transmission)) {
        ++context.counts.refracted;
        sum += transmission * follow(path, at, refracted, at.entering, context);
    }
    return sum;
}

Ray Whitted::leave(const SurfaceInteraction& at, const Vec3& direction, bool crosses) const {
    const double bias = rules_.fixed_bias;
    if (bias == 0) return spawn_ray(at.surface, direction);
    return {at.surface.position + (crosses ? -bias : bias) * at.ng, direction};
}

/// Follows a ray from a surface; `inside`: the new ray runs behind the surface.
Color Whitted::follow(const Path& from, const SurfaceInteraction& at, const Vec3& direction,
                      bool inside, Context& context) const {
    const bool crosses = inside == at.entering;
    Color absorption = from.absorption;
    if (crosses) absorption = inside ? at.material.absorption : Color(0.0F);
    Path path{leave(at, direction, crosses), from.depth + 1, ray_name(from.name, crosses),
              absorption};
    path.ray.coherent = from.ray.coherent;
    const std::optional<Hit> hit = intersector_.closest(path.ray);
    if (hit) ++context.counts.secondary_hits;
    return trace(path, hit, context);
}

}  // namespace etalon
