// Slab tests whose precision is relative to the distance of a box, not only to the scene's size.
// Compiled for each instruction set.
#if defined(ETALON_FINE_SLABS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_FINE_SLABS_INL_H
#undef ETALON_FINE_SLABS_INL_H
#else
#define ETALON_FINE_SLABS_INL_H
#endif

#include "core/accel/wide/slabs-inl.h"
#include "core/intersect/normalized_ray.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// A plane b is crossed at (b - o) / d, with o as the sum of two floats. Boxes may be far smaller
/// than the padding that Passages needs, as those of instances of many sizes are. So they have
/// least_padding, and the ray's slack moves their planes outward. The roundings of o's second float
/// are far below the slack. The other roundings, of the difference, of d, its reciprocal and the
/// result, are at most 6 u of it, u = 2^-24, and as much for the plane on the other side: `from` is
/// reduced by 16 u of itself. A comparison of it with the t of a hit, as for entries of the stack,
/// needs that reduction, too.
class FinePassages {
  public:
    HWY_INLINE FinePassages(const NormalizedRay& ray, const FineRay& fine) {
        for (int k = 0; k < 3; ++k) {
            const float d = divisor(ray.direction[k], 0x1p-60F), reciprocal = 1.0F / d;
            const float outward = std::copysign(fine.slack, d);
            reciprocal_[k] = broadcast(reciprocal);
            origin_[k] = broadcast(ray.origin[k]);
            rest_in_[k] = broadcast((fine.rest[k] + outward) * reciprocal);
            rest_out_[k] = broadcast((fine.rest[k] - outward) * reciprocal);
        }
    }

    HWY_INLINE Floats entry(Floats planes, int k) const { return passage(planes, rest_in_[k], k); }
    HWY_INLINE Floats exit(Floats planes, int k) const { return passage(planes, rest_out_[k], k); }
    HWY_INLINE Floats earliest(Floats from) const { return hn::Mul(from, broadcast(1 - 0x1p-20F)); }

  private:
    HWY_INLINE Floats passage(Floats planes, Floats rest, int k) const {
        return hn::NegMulSub(hn::Sub(origin_[k], planes), reciprocal_[k], rest);
    }

    std::array<Floats, 3> reciprocal_, origin_, rest_in_, rest_out_;
};

using FineSlabs = SlabTest<FinePassages>;

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
