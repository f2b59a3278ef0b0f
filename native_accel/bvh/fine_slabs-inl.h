// Slab tests as precise as the distance to a box, not only as the scene. Compiled for each
// instruction set.
#if defined(ETALON_FINE_SLABS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_FINE_SLABS_INL_H
#undef ETALON_FINE_SLABS_INL_H
#else
#define ETALON_FINE_SLABS_INL_H
#endif

#include "native_accel/common/slabs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// A plane b is passed at (b - o) / d, o in two floats. Boxes may be far smaller than the scene's
/// padding, as those of instances of many sizes are: so most of it is taken off again. What is left,
/// 2 u with u = 2^-24, makes up for the roundings of o in double and of the padding. All others, of
/// the two differences, of d, its reciprocal and the product, are at most 6 u of the result, and
/// those of the plane on the other side as much: `to` is lengthened by 16 u of itself.
class FinePassages {
  public:
    /// `rest`: what the ray's exact origin has over its float one.
    HWY_INLINE FinePassages(const NormalizedRay& ray, const Vec3f& rest) {
        for (int k = 0; k < 3; ++k) {
            const float d = divisor(ray.direction[k]);
            const float inward = std::copysign(taken_off, d);
            reciprocal_[k] = broadcast(1.0F / d);
            origin_[k] = broadcast(ray.origin[k]);
            rest_in_[k] = broadcast(rest[k] - inward);
            rest_out_[k] = broadcast(rest[k] + inward);
        }
    }

    HWY_INLINE Floats entry(Floats planes, int k) const { return passage(planes, rest_in_[k], k); }
    HWY_INLINE Floats exit(Floats planes, int k) const { return passage(planes, rest_out_[k], k); }
    HWY_INLINE Floats latest(Floats to) const {
        return hn::Mul(to, broadcast(1 + 16 * static_cast<float>(unit_roundoff_f)));
    }

  private:
    static constexpr auto taken_off =
        static_cast<float>(NormalizedSpace::padding - 2 * unit_roundoff_f);

    HWY_INLINE Floats passage(Floats planes, Floats rest, int k) const {
        return hn::Mul(hn::Sub(hn::Sub(planes, origin_[k]), rest), reciprocal_[k]);
    }

    std::array<Floats, 3> reciprocal_, origin_, rest_in_, rest_out_;
};

using FineSlabs = SlabTest<FinePassages>;

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
