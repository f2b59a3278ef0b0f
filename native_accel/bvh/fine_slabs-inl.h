// Slab tests as precise as the distance to a box, not only as the scene. Compiled for each
// instruction set.
#if defined(ETALON_FINE_SLABS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_FINE_SLABS_INL_H
#undef ETALON_FINE_SLABS_INL_H
#else
#define ETALON_FINE_SLABS_INL_H
#endif

#include "core/intersect/normalized_ray.h"
#include "native_accel/common/slabs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// A plane b is passed at (b - o) / d, o in two floats: boxes may be far smaller than the padding
/// that Passages need, as those of instances of many sizes are. So they have the least; the ray's
/// slack moves their planes outward. The roundings of the two differences, of d, its reciprocal and
/// the product are at most 6 u of the result, u = 2^-24, and those of the plane on the other side
/// as much: `to` is lengthened by 16 u of itself.
class FinePassages {
  public:
    HWY_INLINE FinePassages(const NormalizedRay& ray, const FineRay& fine) {
        for (int k = 0; k < 3; ++k) {
            const float d = divisor(ray.direction[k], 0x1p-60F);
            const float outward = std::copysign(fine.slack, d);
            reciprocal_[k] = broadcast(1.0F / d);
            origin_[k] = broadcast(ray.origin[k]);
            rest_in_[k] = broadcast(fine.rest[k] + outward);
            rest_out_[k] = broadcast(fine.rest[k] - outward);
        }
    }

    HWY_INLINE Floats entry(Floats planes, int k) const { return passage(planes, rest_in_[k], k); }
    HWY_INLINE Floats exit(Floats planes, int k) const { return passage(planes, rest_out_[k], k); }
    HWY_INLINE Floats latest(Floats to) const { return hn::Mul(to, broadcast(1 + 0x1p-20F)); }

  private:
    HWY_INLINE Floats passage(Floats planes, Floats rest, int k) const {
        return hn::Mul(hn::Sub(hn::Sub(planes, origin_[k]), rest), reciprocal_[k]);
    }

    std::array<Floats, 3> reciprocal_, origin_, rest_in_, rest_out_;
};

using FineSlabs = SlabTest<FinePassages>;

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
