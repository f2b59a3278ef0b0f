// first_hit() of a sphere for several rays: see sphere.h. Compiled for each instruction set.
#if defined(ETALON_SPHERE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_SPHERE_LANES_INL_H
#undef ETALON_SPHERE_LANES_INL_H
#else
#define ETALON_SPHERE_LANES_INL_H
#endif

#include "core/intersect/shapes/ray_lanes-inl.h"
#include "core/intersect/shapes/sphere.h"
#include "core/numerics/exact.h"
#include "core/numerics/two_sum_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Computes fine_gap(), with the same bits where vector multiply-adds round once.
HWY_INLINE Doubles fine_gap(const Sphere& s, const Vec3Lanes& origin) {
    const TwoTerm square = two_product(s.radius, s.radius);
    Doubles sum = broadcast(-square.value), rest = broadcast(-square.error);
    const auto add = [&](Doubles coordinate, double centre) HWY_ATTR {
        const auto f = two_sum(coordinate, broadcast(-centre));
        const Doubles f2 = f.value * f.value, f2_error = hn::MulSub(f.value, f.value, f2);
        const auto next = two_sum(sum, f2);
        sum = next.value;
        rest = rest + (next.error + f2_error + broadcast(2) * f.value * f.error);
    };
    add(origin.x, s.centre.x);
    add(origin.y, s.centre.y);
    add(origin.z, s.centre.z);
    return sum + rest;
}

HWY_INLINE HitLanes first_hits(const Sphere& s, Sides sides, const RayLanes& rays) {
    constexpr double u = unit_roundoff, worst = t_tolerance / 2;
    const double radius2 = s.radius * s.radius;
    if (!(s.radius > 0) || !(radius2 > 0x1p-900)) return all_uncertain();
    const Doubles zero = broadcast(0), r2 = broadcast(radius2);
    const Vec3Lanes f = rays.origin - broadcast(s.centre), &d = rays.direction;
    const Doubles a = d.dot(d), b = hn::Neg(f.dot(d)), f2 = f.dot(f);
    Doubles c = f2 - r2, error_bound_of_c = broadcast(8 * u) * (f2 + r2);
    DoubleMask next_to_surface = broadcast(worst) * hn::Abs(c) < error_bound_of_c;
    if constexpr (HWY_NATIVE_FMA != 0) {
        if (!hn::AllFalse(DoubleTag(), next_to_surface)) {
            c = hn::IfThenElse(next_to_surface, fine_gap(s, rays.origin), c);
            error_bound_of_c = hn::IfThenElse(
                next_to_surface, broadcast(fine_error_bound) * (f2 + r2), error_bound_of_c);
            next_to_surface = hn::FirstN(DoubleTag(), 0);
        }
    }
    const DoubleMask on_its_way_out = hn::And(c > error_bound_of_c, b <= zero);

    const Vec3Lanes m = f.cross(d);
    const Doubles m2 = m.dot(m), ar2 = a * r2, largest = hn::Max(m2, ar2);
    const Doubles discriminant = ar2 - m2;
    const Doubles error_bound2 = broadcast((16 * u) * (16 * u)) * largest * (a * f2 + largest);
    const DoubleMask is_certain =
        hn::And(a > broadcast(0x1p-900), discriminant * discriminant > error_bound2);
    const DoubleMask passes_by = hn::And(is_certain, discriminant < zero);
    const DoubleMask missed = hn::AndNot(next_to_surface, hn::Or(on_its_way_out, passes_by));
    if (hn::AllTrue(DoubleTag(), missed)) return misses();

    const Doubles sum = hn::Abs(b) + hn::Sqrt(discriminant), sum2 = sum * sum;
    const Doubles worst2 = broadcast(worst * worst);
    const DoubleMask from_c = hn::Not(hn::Xor(b > zero, c > zero));
    const Doubles share = hn::IfThenElse(from_c, broadcast(worst), broadcast(1));
    const DoubleMask is_good =
        hn::And(hn::And(error_bound2 <= worst2 * discriminant * sum2,
                        broadcast((8 * u) * (8 * u)) * a * f2 <= worst2 * sum2),
                share * hn::Abs(c) >= error_bound_of_c);
    const DoubleMask decided = hn::AndNot(next_to_surface, hn::And(is_certain, is_good));

    const DoubleMask towards = b >= zero;
    const Doubles by_c = c / sum, by_a = sum / a;
    const Doubles entry = hn::IfThenElse(towards, by_c, hn::Neg(by_a));
    const Doubles exit = hn::IfThenElse(towards, by_a, hn::Neg(by_c));
    return hit_lanes(first_visible(entry, exit, sides, rays), missed, decided);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
