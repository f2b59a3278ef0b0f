#include "core/test_rays/ray_sets.h"

#include <cmath>
#include <numbers>

#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/light/lights.h"
#include "core/render/camera_rays.h"
#include "core/render/tiles.h"
#include "core/sampling/dimensions.h"
#include "core/sampling/hemisphere.h"
#include "core/sampling/sample_source.h"
#include "core/shading/light_samples.h"
#include "core/shading/shadow_rays.h"
#include "core/test_rays/aimed_rays.h"

namespace etalon {
namespace {

constexpr std::uint32_t chord_seed = 3, bounce_seed = 5, time_seed = 11;

/// Pixel centres, tile by tile, every so many that `limit` is kept.
std::vector<Vec2> pixel_centres(const Imath::V2i& resolution, std::size_t limit) {
    const std::size_t all = static_cast<std::size_t>(resolution.x) * resolution.y;
    const std::size_t stride = (all + limit - 1) / limit;
    std::vector<Vec2> centres;
    std::size_t index = 0;
    for (const Imath::Box2i& tile : tiles_of({{0, 0}, resolution - Imath::V2i(1)})) {
        for_each_pixel(tile, [&](int x, int y) {
            if (index++ % stride == 0) centres.emplace_back(x + 0.5, y + 0.5);
        });
    }
    return centres;
}

Vec3 on_unit_sphere(const Vec2& uv) {
    const double z = 1 - 2 * uv.x, radius = std::sqrt(1 - z * z);
    const double angle = 2 * std::numbers::pi * uv.y;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Box3 bounds_of(const Geometry& geometry) {
    const Box3 box = finite_bounds(geometry);
    return box.isEmpty() ? Box3(Vec3(-1), Vec3(1)) : box;
}

Ray shadow_ray(Ray ray) {
    ray.set_coherent();
    ray.set_shadow();
    return ray;
}

/// Returns the ray to a light, which ends before it as those of the renderer do.
Ray shadow_ray_to(const SurfacePoint& p, const Vec3& target) {
    Ray ray = shadow_ray(spawn_ray_to(p, target));
    ray.tmax = shadow_end;
    return ray;
}

class RaySetMaker {
  public:
    RaySetMaker(const Scene& scene, const Imath::V2i& resolution, const Intersector& exact,
                std::size_t limit)
        : scene_(scene),
          exact_(exact),
          limit_(std::max<std::size_t>(limit, 1)),
          camera_(scene.camera, resolution),
          pixels_(pixel_centres(resolution, limit_)) {}

    RaySet camera() const {
        RaySet set{"camera", false, {}};
        for (std::uint32_t i = 0; i < pixels_.size(); ++i) set.rays.push_back(through(i));
        return set;
    }

    RaySet bounce() const {
        RaySet set{"bounce", false, {}};
        for_each_hit([&](const SurfacePoint& p, const Vec3& normal, const SampleSource& sample) {
            const Vec3 direction = cosine_direction(normal, sample.point(bounce_dimension));
            set.rays.push_back(spawn_ray(p, direction));
        });
        return set;
    }

    RaySet shadow() const {
        RaySet set{"shadow", true, {}};
        if (scene_.is_physical()) {
            add_rays_to_lights(scene_, set.rays);
        } else {
            add_rays_to_lights(scene_.whitted().lights, set.rays);
        }
        return set;
    }

    RaySet aimed() const {
        RaySet set{"aimed", false, {}};
        set.rays = rays_at_features(scene_, bounds_of(scene_.geometry), (limit_ + 1) / 2);
        add_rays_at_borders(exact_, camera_, pixels_, limit_, set.rays);
        return set;
    }

    RaySet random() const {
        const Box3 box = bounds_of(scene_.geometry);
        const Vec3 centre = box.center();
        const double radius = std::sqrt(box.size().dot(box.size())) / 2;
        const ScrambledSobol from(chord_seed), to(chord_seed + 1);
        RaySet set{"random", false, {}};
        for (std::uint32_t i = 0; i < pixels_.size(); ++i) {
            const Vec3 a = centre + radius * on_unit_sphere(from(i));
            const Vec3 b = centre + radius * on_unit_sphere(to(i));
            if (a == b) continue;
            set.rays.push_back({a, normalized(b - a)});
            set.rays.back().set_time(time(i));
        }
        return set;
    }

  private:
    void add_rays_to_lights(const std::vector<Light>& lights, std::vector<Ray>& rays) const {
        if (lights.empty()) return;
        for_each_hit([&](const SurfacePoint& p, const Vec3&, const SampleSource& sample) {
            const LightSamples points(lights[rays.size() % lights.size()], 1);
            const Vec3 target =
                points.is_random()
                    ? points.position(sample.stratified(shadow_dimension, 0, points.count()))
                    : points.position(0);
            rays.push_back(shadow_ray_to(p, target));
        });
    }

    void add_rays_to_lights(const Scene& scene, std::vector<Ray>& rays) const {
        std::vector<std::string> problems;  // an image does not change where lights are
        const Lights lights(scene, problems);
        if (lights.empty()) return;
        for_each_hit([&](const SurfacePoint& p, const Vec3&, const SampleSource& sample) {
            const auto light = static_cast<std::uint32_t>(rays.size() % lights.size());
            const LightSample s = lights.sample(light, p.position, sample.point(shadow_dimension));
            const Vec3 up = s.wi == Vec3(0) ? p.normal : s.wi;  // for a light that is not sampled
            rays.push_back(s.at_infinity ? shadow_ray(spawn_ray(p, up))
                                         : shadow_ray_to(p, s.target));
        });
    }

    /// Returns the time of the ray with that number.
    ShutterTime time(std::uint32_t number) const {
        return scene_.camera.sees_motion ? shutter_time(ScrambledSobol(time_seed)(number).x) : 0;
    }

    /// Returns the ray through the pixel with that number.
    Ray through(std::uint32_t number) const {
        Ray ray = camera_.ray(pixels_[number], Vec2(0.5), time(number));
        ray.set_coherent();
        return ray;
    }

    /// f(surface, its normal on the camera's side, a sample source of its own)
    template <class F>
    void for_each_hit(const F& f) const {
        std::uint32_t index = 0;
        for (std::uint32_t i = 0; i < pixels_.size(); ++i) {
            const Ray ray = through(i);
            const std::optional<Hit> hit = exact_.closest(ray);
            if (!hit) continue;
            const SurfacePoint p = surface_at(scene_.geometry, ray, *hit);
            const Vec3 normal = p.normal.dot(ray.direction) < 0 ? p.normal : -p.normal;
            f(p, normal, SampleSource({0, 0, bounce_seed}, index++));
        }
    }

    const Scene& scene_;
    const Intersector& exact_;
    std::size_t limit_;
    CameraRays camera_;
    std::vector<Vec2> pixels_;
};

}  // namespace

RaySet make_ray_set(const std::string& kind, const Scene& scene, const Imath::V2i& resolution,
                    const Intersector& exact, std::size_t limit) {
    const RaySetMaker maker(scene, resolution, exact, limit);
    if (kind == "camera") return maker.camera();
    if (kind == "bounce") return maker.bounce();
    if (kind == "shadow") return maker.shadow();
    return kind == "aimed" ? maker.aimed() : maker.random();
}

double half_size(const Geometry& geometry) {
    return max_abs(bounds_of(geometry).size()) / 2;
}

}  // namespace etalon
