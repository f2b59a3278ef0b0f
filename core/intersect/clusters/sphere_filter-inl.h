// Which spheres of a cluster a ray could hit. Compiled for each instruction set.
#if defined(ETALON_CLUSTERS_SPHERE_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CLUSTERS_SPHERE_FILTER_INL_H
#undef ETALON_CLUSTERS_SPHERE_FILTER_INL_H
#else
#define ETALON_CLUSTERS_SPHERE_FILTER_INL_H
#endif

#include "core/intersect/clusters/doubt.h"
#include "core/intersect/clusters/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// By the distance between the ray's line and the centre.
class SphereFilter {
  public:
    /// Of a ray that has left the primitive `left` (see Ray).
    HWY_INLINE SphereFilter(const FrameRay& ray, float tmin, std::uint32_t left)
        : tmin_(tmin), left_(left) {
        for (int k = 0; k < 3; ++k) {
            origin_[k] = broadcast(ray.origin[k]);
            direction_[k] = broadcast(ray.direction[k]);
        }
        reciprocal_ = broadcast(1 / ray.direction.dot(ray.direction));
    }

    /// The lanes, lowest first, that the ray could hit at tmin < t <= tmax in the frame.
    HWY_INLINE std::uint32_t candidates(const SphereCluster& cluster, float tmax) const {
        return lanes_where([&](std::size_t i) HWY_ATTR { return meets(cluster, i, tmax); });
    }

  private:
    /// The sphere's part of the line is `middle` +- sqrt(reach), an interval that is too wide
    /// rather than too narrow but for the middle's doubt.
    HWY_INLINE Mask meets(const SphereCluster& cluster, std::size_t i, float tmax) const {
        const Floats x = hn::Sub(load(cluster.centre[0], i), origin_[0]),
                     y = hn::Sub(load(cluster.centre[1], i), origin_[1]),
                     z = hn::Sub(load(cluster.centre[2], i), origin_[2]);
        const Floats middle =
            hn::Mul(dot(x, y, z, direction_[0], direction_[1], direction_[2]), reciprocal_);
        const Floats px = hn::NegMulAdd(middle, direction_[0], x),
                     py = hn::NegMulAdd(middle, direction_[1], y),
                     pz = hn::NegMulAdd(middle, direction_[2], z);
        const Floats radius = load(cluster.radius, i);
        const Floats reach = hn::Mul(
            hn::NegMulAdd(px, px,
                          hn::NegMulAdd(py, py, hn::NegMulAdd(pz, pz, hn::Mul(radius, radius)))),
            reciprocal_);
        const Floats doubt = broadcast(middle_doubt), zero = hn::Zero(Tag());
        const Floats beyond = hn::Max(hn::Sub(hn::Sub(middle, doubt), broadcast(tmax)), zero),
                     behind = hn::Max(hn::Sub(hn::Sub(broadcast(tmin_), doubt), middle), zero);
        const Floats gap = hn::Max(beyond, behind);
        const Mask met = hn::And(hn::Ge(reach, zero), hn::Le(hn::Mul(gap, gap), reach));
        return hn::AndNot(holds(cluster.ids, i, left_), met);
    }

    static HWY_INLINE Floats dot(Floats ax, Floats ay, Floats az, Floats bx, Floats by, Floats bz) {
        return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, hn::Mul(az, bz)));
    }

    std::array<Floats, 3> origin_, direction_;
    Floats reciprocal_;
    float tmin_;
    std::uint32_t left_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
