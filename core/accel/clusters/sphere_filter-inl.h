// Filter for the spheres of a cluster that a ray could hit. Compiled for each instruction set.
#if defined(ETALON_CLUSTERS_SPHERE_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CLUSTERS_SPHERE_FILTER_INL_H
#undef ETALON_CLUSTERS_SPHERE_FILTER_INL_H
#else
#define ETALON_CLUSTERS_SPHERE_FILTER_INL_H
#endif

#include "core/accel/clusters/error_bounds.h"
#include "core/accel/clusters/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Tests spheres by the distance between the ray's line and the centre.
class SphereFilter {
  public:
    /// Sets up the test of a ray that skips the primitive `exclude` (see Ray).
    HWY_INLINE SphereFilter(const NormalizedRay& ray, float tmin, std::uint32_t exclude)
        : tmin_(broadcast(tmin - middle_error_bound)), exclude_(exclude) {
        const float length2 = ray.direction.dot(ray.direction), reciprocal = 1 / length2;
        length2_ = broadcast(length2);
        for (int k = 0; k < 3; ++k) {
            origin_[k] = broadcast(ray.origin[k]);
            direction_[k] = broadcast(ray.direction[k]);
            along_[k] = broadcast(ray.direction[k] * reciprocal);
        }
    }

    /// Returns the lanes, lowest first, that the ray could hit at tmin < t <= tmax in normalized
    /// space.
    HWY_INLINE std::uint32_t candidates(const SphereCluster& cluster, float tmax) const {
        return lanes_where([&](std::size_t i) HWY_ATTR { return meets(cluster, i, tmax); });
    }

  private:
    /// The interval of the line inside the sphere is `middle` +- sqrt(reach / length2). It is never
    /// too narrow, apart from the error bound of the middle.
    HWY_INLINE Mask meets(const SphereCluster& cluster, std::size_t i, float tmax) const {
        const Floats x = hn::Sub(load(cluster.centre[0], i), origin_[0]),
                     y = hn::Sub(load(cluster.centre[1], i), origin_[1]),
                     z = hn::Sub(load(cluster.centre[2], i), origin_[2]);
        const Floats middle =
            hn::MulAdd(x, along_[0], hn::MulAdd(y, along_[1], hn::Mul(z, along_[2])));
        const Floats px = hn::NegMulAdd(middle, direction_[0], x),
                     py = hn::NegMulAdd(middle, direction_[1], y),
                     pz = hn::NegMulAdd(middle, direction_[2], z);
        const Floats radius = load(cluster.radius, i);
        const Floats reach = hn::NegMulAdd(
            px, px, hn::NegMulAdd(py, py, hn::NegMulAdd(pz, pz, hn::Mul(radius, radius))));
        const Floats beyond = hn::Sub(middle, broadcast(tmax + middle_error_bound)),
                     behind = hn::Sub(tmin_, middle);
        const Floats gap = hn::Max(hn::Max(beyond, behind), hn::Zero(Tag()));
        const Mask met = hn::Le(hn::Mul(hn::Mul(gap, gap), length2_), reach);
        return hn::AndNot(holds(cluster.ids, i, exclude_), met);
    }

    std::array<Floats, 3> origin_, direction_, along_;
    Floats length2_, tmin_;
    std::uint32_t exclude_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
