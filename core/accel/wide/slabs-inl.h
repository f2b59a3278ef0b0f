// Slab tests of a ray with the boxes of a node. Compiled for each instruction set.
#if defined(ETALON_SLABS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_SLABS_INL_H
#undef ETALON_SLABS_INL_H
#else
#define ETALON_SLABS_INL_H
#endif

#include "core/accel/clusters/lanes-inl.h"
#include "core/accel/wide/wide_node.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Returns a component of a ray's direction, raised to the magnitude `least`. This avoids infinity
/// times zero; over the few units that a ray travels in normalized space it shifts the ray by far
/// less than the padding.
HWY_INLINE float divisor(float d, float least) {
    return std::abs(d) < least ? std::copysign(least, d) : d;
}

/// Slab test (Kay & Kajiya 1986) of a ray with the eight boxes of a node. `Passages` computes where
/// the ray crosses planes.
template <class Passages>
class SlabTest {
  public:
    template <class... Arguments>
    HWY_INLINE SlabTest(const NormalizedRay& ray, float tmin, const Arguments&... arguments)
        : passages_(ray, arguments...), tmin_(broadcast(tmin)) {
        for (int k = 0; k < 3; ++k) near_[k] = WideNode::plane(k, std::signbit(ray.direction[k]));
    }
    SlabTest(const SlabTest&) = delete;
    SlabTest& operator=(const SlabTest&) = delete;

    /// Returns the lanes whose box is entered within [tmin, tmax], and the t of entry.
    HWY_INLINE std::uint32_t entered(const WideNode& node, float tmax, Lanes& entry) const {
        std::uint32_t found = 0;
        for (std::size_t i = 0; i < node_width; i += hn::MaxLanes(Tag())) {
            Floats from = tmin_, to = broadcast(tmax);
            for (int k = 0; k < 3; ++k) {
                const std::size_t near = near_[k] + i, far = (near_[k] ^ node_width) + i;
                from = hn::Max(from, passages_.entry(hn::Load(Tag(), &node.planes[near]), k));
                to = hn::Min(to, passages_.exit(hn::Load(Tag(), &node.planes[far]), k));
            }
            from = passages_.earliest(from);
            hn::Store(from, Tag(), &entry[i]);
            found |= bits(hn::Le(from, to), i);
        }
        return found;
    }

  private:
    Passages passages_;
    Floats tmin_;
    std::array<std::size_t, 3> near_;  ///< WideNode::plane
};

/// A plane b is crossed at b / d - o / d, in float. With u = 2^-24, |o| <= 3 and |b| <= 1, its
/// place is off by u (|o| + |b|) for each of the roundings of d, its reciprocal, and the result; by
/// u |o| for that of o / d, and 2.1 u for o's own: together u (4 |o| + 3 |b| + 2.1) <= 17.1 u, or
/// 20 u if b / d is rounded too. The boxes' padding (NormalizedSpace::box), 26 u, compensates for
/// it.
class Passages {
  public:
    HWY_INLINE explicit Passages(const NormalizedRay& ray) {
        for (int k = 0; k < 3; ++k) {
            const float reciprocal = 1.0F / divisor(ray.direction[k], 0x1p-40F);
            reciprocal_[k] = broadcast(reciprocal);
            offset_[k] = broadcast(ray.origin[k] * reciprocal);
        }
    }

    HWY_INLINE Floats entry(Floats planes, int k) const {
        return hn::MulSub(planes, reciprocal_[k], offset_[k]);
    }
    HWY_INLINE Floats exit(Floats planes, int k) const { return entry(planes, k); }
    HWY_INLINE Floats earliest(Floats from) const { return from; }

  private:
    std::array<Floats, 3> reciprocal_, offset_;
};

using Slabs = SlabTest<Passages>;

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
