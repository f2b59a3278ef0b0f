// Vertices at which a path is scattered: on surfaces and in media, with the same interface.
#pragma once

#include "core/bsdf/bsdf_from.h"
#include "core/diffusion/subsurface.h"
#include "core/integrators/path/lit_regions_from.h"
#include "core/integrators/path/wave_points.h"
#include "core/medium/henyey_greenstein.h"
#include "core/medium/ray_segment.h"
#include "core/shading/physical_surface.h"

namespace etalon {

struct PathVertex {
    VertexNumbers numbers;
    std::uint32_t split_count;  ///< number of paths that continue
    float survival = 1;         ///< probability of each, if it is decided before the direction
    const LitRegionsFrom* lit_regions = nullptr;  ///< regions to which some directions go, or null

    /// Returns how many paths continue, on average.
    float expected_paths() const { return static_cast<float>(split_count) * survival; }
};

/// Returns the medium on the side of a surface to which `direction` leaves it; `medium` is that of
/// the incoming ray.
inline std::uint32_t medium_beyond(const PhysicalSurface& at, const Vec3& direction,
                                   std::uint32_t medium) {
    const MediumInterface& media = at.binding->media;
    if (!media.is_transition()) return medium;
    return direction.dot(at.ng) > 0 ? media.outside : media.inside;
}

/// A vertex on a surface.
struct SurfaceVertex : PathVertex {
    const PhysicalSurface& surface;
    const BsdfFrame& frame;
    BsdfFrom scattering;                     ///< for the direction from which the path came
    std::uint32_t medium;                    ///< medium through which it came
    const Subsurface* subsurface = nullptr;  ///< subsurface scattering, or null

    /// With subsurface scattering, light from below comes from where it entered elsewhere.
    Evaluation evaluate(const Vec3& wi) const {
        return subsurface && scattering.passes(wi) ? Evaluation{} : scattering.evaluate(wi);
    }
    std::optional<BsdfSample> sample(float choice, const Vec2& uv) const {
        return scattering.sample(choice, uv);
    }
    /// Returns whether the direction is on the side from which the path came by both normals:
    /// BsdfSample::only_lights is false for such directions.
    bool reflects(const Vec3& wi) const { return scattering.reflects(wi); }
    float cosine(const Vec3& wi) const { return static_cast<float>(std::abs(frame.ns.dot(wi))); }
    Ray ray(const Vec3& wi) const { return spawn_ray(surface.point, wi); }
    Ray ray_to(const Vec3& target) const { return spawn_ray_to(surface.point, target); }
    std::uint32_t medium_towards(const Vec3& wi) const {
        return medium_beyond(surface, wi, medium);
    }
};

/// A vertex in a medium.
struct MediumVertex : PathVertex {
    Vec3 position;
    Vec3 direction;  ///< unit, from where the path came
    const HenyeyGreenstein& phase;
    std::uint32_t medium;
    ShutterTime time;
    RaySegment flight;  ///< the whole ray on which it was sampled
    float density;      ///< of that, per unit of length, if a light was sampled beside

    Evaluation evaluate(const Vec3& wi) const {
        const float value = phase.value(direction.dot(wi));
        return {Color(value), value};
    }
    std::optional<BsdfSample> sample(float, const Vec2& uv) const {
        const Vec3 wi = phase.sample(direction, uv);
        const float value = phase.value(direction.dot(wi));
        return BsdfSample{wi, Color(value), value, false, false, false, 1};
    }
    static bool reflects(const Vec3&) { return true; }
    static float cosine(const Vec3&) { return 1; }
    Ray ray(const Vec3& wi) const {
        Ray ray{position, wi};
        ray.set_time(time);
        return ray;
    }
    Ray ray_to(const Vec3& target) const {
        Ray ray = this->ray(target - position);
        ray.tmax = 1;
        return ray;
    }
    std::uint32_t medium_towards(const Vec3&) const { return medium; }
};

}  // namespace etalon
