#include "core/shading/shadow_rays.h"

#include <algorithm>
#include <array>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shading/shadow_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

#ifndef ETALON_SHADOW_RAYS_ONCE
#define ETALON_SHADOW_RAYS_ONCE
namespace etalon {

/// Some surfaces and what becomes of each: so many that they stay in the fastest cache.
struct AimedChunk {
    static constexpr std::size_t most = 64;

    const Vec3 *positions, *errors, *normals, *shading_normals;
    std::array<Vec3, most> lights;
    std::size_t count;

    std::array<Vec3, most> towards;              ///< unit vector to the light
    std::array<double, most> cosine, facing;     ///< products of it with the two normals
    std::array<Vec3, most> origins, directions;  ///< of the ray
    std::array<double, most>
        leaving;  ///< normal . (light - position), its sign that of the side left to
    std::array<double, most> moving;  ///< that side's normal . direction
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void aim(AimedChunk& c, double fixed_bias) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0.0), one = broadcast(1.0), bias = broadcast(fixed_bias);
    for (std::size_t i = 0; i < c.count; i += hn::Lanes(tag)) {
        const Vec3Lanes position = load(c.positions + i), normal = load(c.normals + i);
        const Vec3Lanes light = load(&c.lights[i]), to_light = light - position;
        const Vec3Lanes towards = normalized(to_light);
        const Doubles facing = normal.dot(towards), leaving = normal.dot(to_light);
        store(towards, &c.towards[i]);
        hn::StoreU(load(c.shading_normals + i).dot(towards), tag, &c.cosine[i]);
        hn::StoreU(facing, tag, &c.facing[i]);

        const Doubles side = hn::IfThenElse(leaving < zero, hn::Neg(one), one);
        Vec3Lanes origin;
        if (fixed_bias == 0) {
            const Doubles distance = abs(normal).dot(load(c.errors + i));
            const Vec3Lanes offset = (side * distance) * normal;
            origin = next_towards(position + offset, offset);
        } else {
            const Doubles front = hn::IfThenElse(facing < zero, hn::Neg(bias), bias);
            origin = position + front * normal;
        }
        const Vec3Lanes direction = light - origin;
        store(origin, &c.origins[i]);
        store(direction, &c.directions[i]);
        hn::StoreU(leaving, tag, &c.leaving[i]);
        hn::StoreU(side * normal.dot(direction), tag, &c.moving[i]);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(aim);

namespace {

/// Whether a ray that leaves a surface cannot meet it again.
bool leaves_for_good(Convexity convexity, double leaving, double moving) {
    const bool outward = leaving > 0;
    return (convexity == Convexity::flat || (convexity == Convexity::convex && outward)) &&
           moving > 0;
}

}  // namespace

ShadowRays::ShadowRays(const SeenSurfaces& surfaces, std::span<const Vec3> lights,
                       double fixed_bias) {
    rays.reserve(surfaces.size());
    facing.reserve(surfaces.size());
    AimedChunk c;
    for (std::size_t first = 0; first < surfaces.size(); first += AimedChunk::most) {
        c.positions = &surfaces.positions[first];
        c.errors = &surfaces.errors[first];
        c.normals = &surfaces.normals[first];
        c.shading_normals = &surfaces.shading_normals[first];
        c.count = std::min(AimedChunk::most, surfaces.size() - first);
        std::ranges::copy(lights.subspan(first, c.count), c.lights.begin());
        HWY_DYNAMIC_DISPATCH(aim)(c, fixed_bias);
        for (std::size_t i = 0; i < c.count; ++i) {
            const double facing_it = surfaces.fronts[first + i] * c.facing[i];
            if (!(c.cosine[i] > 0) || !(facing_it > 0)) continue;
            const SeenSurfaces::Traits& traits = surfaces.traits[first + i];
            if (!traits.scatters) continue;
            const bool for_good =
                fixed_bias == 0 && leaves_for_good(traits.convexity, c.leaving[i], c.moving[i]);
            Ray& ray = rays.emplace_back();
            ray.origin = c.origins[i];
            ray.direction = c.directions[i];
            ray.tmax = shadow_end;
            if (for_good) ray.exclude = traits.primitive;
            FacingSurface& surface = facing.emplace_back();
            surface.surface = first + i;
            surface.towards = c.towards[i];
            surface.cosine = c.cosine[i];
        }
    }
}

}  // namespace etalon
#endif
