// Filter for the triangles of a cluster that a ray could hit. Compiled for each instruction set.
#if defined(ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H
#undef ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H
#else
#define ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H
#endif

#include <algorithm>

#include "core/accel/clusters/error_bounds.h"
#include "core/accel/clusters/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Tests triangles by edge functions.
class TriangleFilter {
  public:
    HWY_INLINE TriangleFilter(const RayQuery& query, const NormalizedRay& ray)
        : kx_(query.kx), ky_(query.ky), kz_(query.kz), exclude_(query.ray.excluded()) {
        const float dz = ray.direction[kz_];
        slope_x_ = broadcast(ray.direction[kx_] / dz);
        slope_y_ = broadcast(ray.direction[ky_] / dz);
        origin_x_ = broadcast(ray.origin[kx_]);
        origin_y_ = broadcast(ray.origin[ky_]);
        origin_z_ = broadcast(ray.origin[kz_]);
        forward_ = broadcast(std::copysign(1.0F, dz));
        speed_ = std::abs(dz);
    }

    /// Returns the lanes, lowest first, that the ray could hit at t <= tmax in normalized space.
    HWY_INLINE std::uint32_t candidates(const TriangleCluster& cluster, float tmax) const {
        return lanes_where([&](std::size_t i) HWY_ATTR { return meets(cluster, i, tmax); });
    }

  private:
    struct Corner {
        Floats x, y, z;
    };

    HWY_INLINE Mask meets(const TriangleCluster& cluster, std::size_t i, float tmax) const {
        const Corner a = shear(cluster.corners[0], i), b = shear(cluster.corners[1], i),
                     c = shear(cluster.corners[2], i);
        const Floats error_bound = broadcast(cluster.error_bound);
        const Floats u = edge(b, c), v = edge(c, a), w = edge(a, b);
        const Mask around = hn::Or(hn::Ge(hn::Min(u, hn::Min(v, w)), hn::Neg(error_bound)),
                                   hn::Le(hn::Max(u, hn::Max(v, w)), error_bound));
        const Mask surrounds = hn::AndNot(holds(cluster.ids, i, exclude_), around);
        if (hn::AllFalse(Tag(), surrounds)) return surrounds;
        return hn::AndNot(surely_beyond(tmax, {u, v, w}, {a.z, b.z, c.z}, error_bound), surrounds);
    }

    HWY_INLINE Corner shear(const std::array<Lanes, 3>& p, std::size_t i) const {
        const Floats z = hn::Sub(load(p[kz_], i), origin_z_);
        return {hn::NegMulAdd(slope_x_, z, hn::Sub(load(p[kx_], i), origin_x_)),
                hn::NegMulAdd(slope_y_, z, hn::Sub(load(p[ky_], i), origin_y_)), z};
    }

    static HWY_INLINE Floats edge(const Corner& a, const Corner& b) {
        return hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x));
    }

    /// The depth of the hit is the mean of the corners' depths, weighted by |U|, |V|, |W|. It is
    /// beyond the depth of tmax if the sum of |U| q is positive, where q is a corner's depth minus
    /// that of tmax. The computed sum is off by error bound * (sum of |q|), which includes the
    /// share of the error bound that is reserved for the roundings of this sum, 3 u |U| <= 24 u L^2
    /// <= 48 u L < 1.8 E L. Where the sign of U + V + W is wrong, none of the three exceeds twice
    /// the error bound in magnitude, nor does the sum.
    HWY_INLINE Mask surely_beyond(float tmax, const Corner& weight, const Corner& depth,
                                  Floats error_bound) const {
        const Floats limit = broadcast(std::clamp(tmax * speed_, -8.0F, 8.0F) + depth_error_bound);
        const Floats qx = hn::MulSub(forward_, depth.x, limit),
                     qy = hn::MulSub(forward_, depth.y, limit),
                     qz = hn::MulSub(forward_, depth.z, limit);
        const Floats sum =
            hn::MulAdd(weight.x, qx, hn::MulAdd(weight.y, qy, hn::Mul(weight.z, qz)));
        const Floats sense = hn::Add(weight.x, hn::Add(weight.y, weight.z));
        const Floats turned = hn::IfThenElse(hn::Gt(sense, hn::Zero(Tag())), sum, hn::Neg(sum));
        const Floats size = hn::Add(hn::Abs(qx), hn::Add(hn::Abs(qy), hn::Abs(qz)));
        return hn::Gt(turned, hn::Mul(hn::Add(error_bound, error_bound), size));
    }

    int kx_, ky_, kz_;
    Floats origin_x_, origin_y_, origin_z_, slope_x_, slope_y_, forward_;
    float speed_;
    std::uint32_t exclude_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
