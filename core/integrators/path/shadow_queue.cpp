#include "core/integrators/path/shadow_queue.h"

#include <numeric>

#include "core/integrators/path/path_vertices.h"
#include "core/integrators/path/ray_segments.h"

namespace etalon {

void ShadowQueue::clear() {
    rays_.clear();
    lights_.clear();
    passages_.clear();
}

void ShadowQueue::trace(const PathScene& scene, std::span<Color> colors, RayCounts& counts) {
    blocked_.resize(rays_.size());
    counts.shadow += rays_.size();
    if (passages_.empty()) {
        scene.intersector.occluded(rays_, blocked_);
    } else {
        attenuate_all(scene, counts);
    }
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        counts.shadow_blocked += blocked_[i];
        if (blocked_[i] == 0) colors[lights_[i].sample] += lights_[i].color;
    }
}

/// Attenuates the light by what is in between: surfaces block it, media let a part pass.
void ShadowQueue::attenuate_all(const PathScene& scene, RayCounts& counts) {
    if (scene.shading.has_null_materials()) return pass_surfaces(scene, counts);
    scene.intersector.occluded(rays_, blocked_);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (blocked_[i] == 0) attenuate(scene, i, rays_[i], rays_[i].tmax);
    }
}

/// Traces the rays from one surface without a material to the next.
void ShadowQueue::pass_surfaces(const PathScene& scene, RayCounts& counts) {
    std::ranges::fill(blocked_, std::uint8_t{0});
    passing_.resize(rays_.size());
    std::iota(passing_.begin(), passing_.end(), 0U);
    passing_rays_ = rays_;
    while (!passing_.empty()) {
        passing_hits_.resize(passing_rays_.size());
        scene.intersector.closest(passing_rays_, passing_hits_);
        std::size_t count = 0;
        for (std::size_t i = 0; i < passing_.size(); ++i) {
            if (!passes(scene, passing_[i], passing_rays_[i], passing_hits_[i])) continue;
            passing_[count] = passing_[i];
            passing_rays_[count++] = passing_rays_[i];
        }
        passing_.resize(count);
        passing_rays_.resize(count);
        counts.shadow += count;
    }
}

/// Attenuates a contribution by the medium that its ray passes up to `end`.
void ShadowQueue::attenuate(const PathScene& scene, std::size_t number, const Ray& ray,
                            double end) {
    auto& [medium, numbers] = passages_[number];
    if (medium == no_index) return;
    lights_[number].color *= scene.media.transmittance(medium, segment_of(ray, end), numbers);
}

/// Returns whether a ray continues beyond its hit, if there is one. `ray` becomes the rest of it.
bool ShadowQueue::passes(const PathScene& scene, std::size_t number, Ray& ray, const Hit& hit) {
    if (hit.primitive == no_index) {
        attenuate(scene, number, ray, ray.tmax);
        return false;
    }
    const PhysicalSurface at = physical_surface(scene.scene, ray, hit);
    if (!has_null_material(scene.scene, at)) {
        blocked_[number] = 1;
        return false;
    }
    attenuate(scene, number, ray, hit.t);
    if (lights_[number].color == Color(0.0F)) return false;
    std::uint32_t& medium = passages_[number].medium;
    medium = medium_beyond(at, ray.direction, medium);
    ray = ray_beyond(ray, hit, at.point.convexity);
    return ray.tmin < ray.tmax;
}

}  // namespace etalon
