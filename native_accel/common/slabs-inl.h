// Slab tests of a ray with the boxes of a node. Compiled for each instruction set.
#if defined(ETALON_SLABS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_SLABS_INL_H
#undef ETALON_SLABS_INL_H
#else
#define ETALON_SLABS_INL_H
#endif

#include "core/accel/clusters/lanes-inl.h"
#include "native_accel/common/wide_node.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Slab tests in float: a plane b is passed at b / d - o / d. With u = 2^-24, |o| <= 3 and |b| <=
/// 1, its place is off by u (|o| + |b|) for each of the roundings of d, its reciprocal, and the
/// result; by u |o| for that of o / d, and 2.1 u for o's own: together u (4 |o| + 3 |b| + 2.1)
/// <= 17.1 u, 20 u where b / d is rounded too. The boxes' padding (NormalizedSpace::box), 26 u,
/// makes up for it.
class Slabs {
  public:
    HWY_INLINE Slabs(const NormalizedRay& ray, float tmin) : tmin_(broadcast(tmin)) {
        for (int k = 0; k < 3; ++k) {
            // No smaller than 2^-40 of the largest component: no infinity times zero, and over the
            // few units a ray can travel in normalized space a drift far below the padding.
            const float d = ray.direction[k];
            const float clamped = std::abs(d) < 0x1p-40F ? std::copysign(0x1p-40F, d) : d;
            const float reciprocal = 1.0F / clamped;
            reciprocal_[k] = broadcast(reciprocal);
            offset_[k] = broadcast(ray.origin[k] * reciprocal);
            near_[k] = WideNode::plane(k, std::signbit(clamped));
        }
    }

    /// The lanes whose box is entered within [tmin, tmax], and where.
    HWY_INLINE std::uint32_t entered(const WideNode& node, float tmax, Lanes& entry) const {
        std::uint32_t found = 0;
        for (std::size_t i = 0; i < node_width; i += hn::MaxLanes(Tag())) {
            Floats from = tmin_, to = broadcast(tmax);
            for (int k = 0; k < 3; ++k) {
                from = hn::Max(from, passage(node, near_[k] + i, k));
                const std::size_t far = near_[k] ^ node_width;
                to = hn::Min(to, passage(node, far + i, k));
            }
            hn::Store(from, Tag(), &entry[i]);
            found |= bits(hn::Le(from, to), i);
        }
        return found;
    }

  private:
    HWY_INLINE Floats passage(const WideNode& node, std::size_t place, int k) const {
        const Floats planes = hn::Load(Tag(), &node.planes[place]);
        return hn::MulSub(planes, reciprocal_[k], offset_[k]);
    }

    Floats tmin_;
    std::array<Floats, 3> reciprocal_, offset_;
    std::array<std::size_t, 3> near_;  ///< WideNode::plane
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
