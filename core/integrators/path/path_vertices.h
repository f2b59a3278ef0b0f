// What scatters a path at its vertices: surfaces and media, with the same functions.
#pragma once

#include "core/bsdf/bsdf_from.h"
#include "core/diffusion/subsurface.h"
#include "core/integrators/path/lit_regions.h"
#include "core/medium/henyey_greenstein.h"
#include "core/medium/ray_segment.h"
#include "core/shading/physical_surface.h"

namespace etalon {

/// Where the choices of a vertex are.
struct VertexNumbers {
    std::size_t vertex = 0;     ///< among those that may scatter
    std::size_t first_way = 0;  ///< among the ways that they may go on
};

struct PathVertex {
    VertexNumbers numbers;
    std::uint32_t ways;  ///< in which the path goes on
    float survival = 1;  ///< probability of each, where it is chosen before the direction
    const LitRegionsFrom* lit_regions = nullptr;  ///< to which some of its directions go, if to any

    /// How many ways the path goes on, on average.
    float expected_ways() const { return static_cast<float>(ways) * survival; }
};

/// The medium on the side of a surface to which `direction` leaves it; `medium` is the one that the
/// ray to the surface came through.
inline std::uint32_t medium_beyond(const PhysicalSurface& at, const Vec3& direction,
                                   std::uint32_t medium) {
    const MediumInterface& media = at.binding->media;
    if (!media.is_transition()) return medium;
    return direction.dot(at.ng) > 0 ? media.outside : media.inside;
}

/// A point of a surface.
struct SurfaceVertex : PathVertex {
    const PhysicalSurface& surface;
    const BsdfFrame& frame;
    BsdfFrom scattering;                     ///< to where the path came from
    std::uint32_t medium;                    ///< through which it came
    const Subsurface* subsurface = nullptr;  ///< what scatters light below the surface, if anything

    /// Light straight through a surface that scatters it below is no other than that of lights that
    /// are asked: the path comes out elsewhere.
    Evaluation evaluate(const Vec3& wi) const {
        Evaluation e = scattering.evaluate(wi);
        if (subsurface && scattering.passes(wi)) e.pdf = 0;
        return e;
    }
    std::optional<BsdfSample> sample(float choice, const Vec2& uv) const {
        return scattering.sample(choice, uv);
    }
    /// Whether the direction is on the side that the path came from, above both horizons.
    bool reflects(const Vec3& wi) const {
        const double above = surface.ng.dot(wi);
        return !scattering.passes(wi) && above * frame.ns.dot(wi) * surface.ng.dot(frame.ns) > 0;
    }
    float cosine(const Vec3& wi) const { return static_cast<float>(std::abs(frame.ns.dot(wi))); }
    Ray ray(const Vec3& wi) const { return spawn_ray(surface.point, wi); }
    Ray ray_to(const Vec3& target) const { return spawn_ray_to(surface.point, target); }
    std::uint32_t medium_towards(const Vec3& wi) const {
        return medium_beyond(surface, wi, medium);
    }
};

/// A point of a medium.
struct MediumVertex : PathVertex {
    Vec3 position;
    Vec3 direction;  ///< unit, from where the path came
    const HenyeyGreenstein& phase;
    std::uint32_t medium;
    ShutterTime time;
    RaySegment flight;  ///< all of the ray on which it was chosen
    float density;      ///< with which it was, per unit of length, if a light was asked beside

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
