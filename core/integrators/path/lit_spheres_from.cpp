#include "core/integrators/path/lit_spheres_from.h"

#include <numbers>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/integrators/path/lit_spheres_from.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, LitSpheresFrom::count>;
using Floats = hn::Vec<FloatTag>;

HWY_INLINE Floats set(float x) {
    return hn::Set(FloatTag(), x);
}
HWY_INLINE Floats load(const std::array<float, LitSpheresFrom::count>& from, std::size_t k) {
    return hn::LoadU(FloatTag(), &from[k]);
}
HWY_INLINE void store(Floats x, std::array<float, LitSpheresFrom::count>& to, std::size_t k) {
    hn::StoreU(x, FloatTag(), &to[k]);
}

/// Sets cones and weights from vectors to the spheres' centres. `normal` is the receiver's.
void see(const LitSpheres& spheres, const Vec3f& normal, LitSpheresFrom& seen) {
    const Floats zero = set(0), one = set(1);
    const bool sees_all = normal == Vec3f(0);
    for (std::size_t k = 0; k < LitSpheresFrom::count; k += hn::Lanes(FloatTag())) {
        const Floats x = load(seen.x, k), y = load(seen.y, k), z = load(seen.z, k);
        const Floats radius = load(spheres.radius, k), power = load(spheres.power, k);
        const Floats distance2 = x * x + y * y + z * z, radius2 = radius * radius;
        const auto is_outside = distance2 > radius2;
        const Floats scale = hn::IfThenElseZero(is_outside, one / hn::Sqrt(distance2));
        store(x * scale, seen.x, k);
        store(y * scale, seen.y, k);
        store(hn::IfThenElse(is_outside, z * scale, one), seen.z, k);
        const Floats sine2 = radius2 * scale * scale;
        const Floats outside = sine2 / (one + hn::Sqrt(hn::Max(one - sine2, zero)));
        store(hn::IfThenElse(is_outside, outside, set(2)), seen.sagitta, k);
        // A sphere below the horizon of a receiver, if that has one, is not visible.
        const Floats above = set(normal.x) * x + set(normal.y) * y + set(normal.z) * z;
        const Floats weight = power / hn::Max(distance2, radius2);
        const auto is_seen = above > hn::Neg(radius);
        store(sees_all ? weight : hn::IfThenElseZero(is_seen, weight), seen.weights, k);
    }
}

void share(float sum, LitSpheresFrom& seen) {
    constexpr auto turn = static_cast<float>(2 * std::numbers::pi);
    for (std::size_t k = 0; k < LitSpheresFrom::count; k += hn::Lanes(FloatTag())) {
        const Floats weight = load(seen.weights, k);
        const Floats solid_angle = set(turn) * load(seen.sagitta, k);
        store(hn::IfThenElseZero(weight > set(0), weight / (solid_angle * set(sum))),
              seen.densities, k);
    }
}

/// Sets the densities of the cones that a vector, the sum of both, is in; 0 for the others. An axis
/// is of length 1 up to 3e-7, and the squared distance has a relative error of 4e-7. The limit
/// leaves room for both, since without a density a direction sampled at a narrow cone's edge would
/// weigh as much as if few were sampled there.
void find_densities(const LitSpheresFrom& seen, const Vec3f& rounded, const Vec3f& rest,
                    std::array<float, LitSpheresFrom::count>& densities) {
    constexpr float twice = 2 + 2e-6F, room = 1e-13F;
    for (std::size_t k = 0; k < LitSpheresFrom::count; k += hn::Lanes(FloatTag())) {
        const Floats x = set(rounded.x) - load(seen.x, k) + set(rest.x),
                     y = set(rounded.y) - load(seen.y, k) + set(rest.y),
                     z = set(rounded.z) - load(seen.z, k) + set(rest.z);
        const auto is_in = x * x + y * y + z * z <= set(twice) * load(seen.sagitta, k) + set(room);
        store(hn::IfThenElseZero(is_in, load(seen.densities, k)), densities, k);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(see);
HWY_EXPORT(share);
HWY_EXPORT(find_densities);

LitSpheresFrom::LitSpheresFrom(const LitSpheres& spheres, const Receiver& at) {
    for (std::size_t k = 0; k < count; ++k) {
        x[k] = static_cast<float>(spheres.x[k] - at.position.x);
        y[k] = static_cast<float>(spheres.y[k] - at.position.y);
        z[k] = static_cast<float>(spheres.z[k] - at.position.z);
    }
    HWY_DYNAMIC_DISPATCH(see)(spheres, Vec3f(at.normal), *this);
}

void LitSpheresFrom::share(float sum) {
    HWY_DYNAMIC_DISPATCH(share)(sum, *this);
}

float LitSpheresFrom::density(const Vec3& direction) const {
    const Vec3f rounded(direction), rest(direction - Vec3(rounded));
    std::array<float, count> some;
    HWY_DYNAMIC_DISPATCH(find_densities)(*this, rounded, rest, some);
    float sum = 0;
    for (const float density : some) sum += density;
    return sum;
}

}  // namespace etalon
#endif
