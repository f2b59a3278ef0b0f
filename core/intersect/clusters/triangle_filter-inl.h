// Which triangles of a cluster a ray could hit. Compiled for each instruction set.
#if defined(ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H
#undef ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H
#else
#define ETALON_CLUSTERS_TRIANGLE_FILTER_INL_H
#endif

#include <algorithm>

#include "core/intersect/clusters/doubt.h"
#include "core/intersect/clusters/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// By edge functions.
class TriangleFilter {
  public:
    /// Of a ray that has left the primitive `left` (see Ray).
    HWY_INLINE TriangleFilter(const FrameRay& ray, std::uint32_t left) : left_(left) {
        kz_ = dominant_axis(Vec3(ray.direction));
        kx_ = (kz_ + 1) % 3;
        ky_ = (kz_ + 2) % 3;
        const float dz = ray.direction[kz_];
        slope_x_ = broadcast(ray.direction[kx_] / dz);
        slope_y_ = broadcast(ray.direction[ky_] / dz);
        origin_x_ = broadcast(ray.origin[kx_]);
        origin_y_ = broadcast(ray.origin[ky_]);
        origin_z_ = broadcast(ray.origin[kz_]);
        forward_ = broadcast(std::copysign(1.0F, dz));
        speed_ = std::abs(dz);
    }

    /// The lanes, lowest first, that the ray could hit at t <= tmax in the frame.
    HWY_INLINE std::uint32_t candidates(const TriangleCluster& cluster, float tmax) const {
        const Floats scale = broadcast(cluster.steps_per_unit);
        const Floats z = hn::Sub(broadcast(cluster.base[kz_]), origin_z_);
        const auto sheared = [&](int axis, Floats origin, Floats slope) HWY_ATTR {
            const Floats x = hn::Sub(broadcast(cluster.base[axis]), origin);
            return hn::Mul(hn::NegMulAdd(slope, z, x), scale);
        };
        const Corner base{sheared(kx_, origin_x_, slope_x_), sheared(ky_, origin_y_, slope_y_),
                          hn::Mul(z, scale)};
        return cluster.taken &
               lanes_where([&](std::size_t i) HWY_ATTR { return meets(cluster, base, i, tmax); });
    }

  private:
    struct Corner {
        Floats x, y, z;
    };

    /// In steps of the cluster's grid, whose base is at `base`.
    HWY_INLINE Mask meets(const TriangleCluster& cluster, const Corner& base, std::size_t i,
                          float tmax) const {
        const Corner a = shear(cluster.corners[0], base, i), b = shear(cluster.corners[1], base, i),
                     c = shear(cluster.corners[2], base, i);
        const Floats doubt = broadcast(cluster.doubt);
        const Floats u = edge(b, c), v = edge(c, a), w = edge(a, b);
        const Mask around = hn::Or(hn::Ge(hn::Min(u, hn::Min(v, w)), hn::Neg(doubt)),
                                   hn::Le(hn::Max(u, hn::Max(v, w)), doubt));
        const Mask surrounds = hn::AndNot(holds(cluster.ids, i, left_), around);
        if (hn::AllFalse(Tag(), surrounds)) return surrounds;
        const float end = std::clamp(tmax * speed_, -8.0F, 8.0F) + depth_doubt;
        const Floats limit = broadcast(end * cluster.steps_per_unit + 1);
        const auto beyond = [&](const Corner& p) HWY_ATTR {
            return hn::MulSub(forward_, hn::Add(p.z, base.z), limit);
        };
        return hn::AndNot(surely_beyond({u, v, w}, {beyond(a), beyond(b), beyond(c)}, doubt),
                          surrounds);
    }

    HWY_INLINE Corner shear(const std::array<Steps, 3>& p, const Corner& base,
                            std::size_t i) const {
        const Floats z = load(p[kz_], i);
        return {hn::Add(base.x, hn::NegMulAdd(slope_x_, z, load(p[kx_], i))),
                hn::Add(base.y, hn::NegMulAdd(slope_y_, z, load(p[ky_], i))), z};
    }

    static HWY_INLINE Floats edge(const Corner& a, const Corner& b) {
        return hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x));
    }

    /// The hit is at the mean of the corners' depths, weighted by |U|, |V|, |W|. It is beyond the
    /// depth of tmax if the sum of |U| q is positive, q being each corner's depth less that. What
    /// is computed is off by doubt * (sum of |q|), with the share of the doubt that is kept for the
    /// roundings of this sum, 3 u |U| <= 24 u L^2. Where the sign of U + V + W is wrong none of the
    /// three is beyond twice the doubt in size, nor is the sum.
    static HWY_INLINE Mask surely_beyond(const Corner& weight, const Corner& q, Floats doubt) {
        const Floats sum =
            hn::MulAdd(weight.x, q.x, hn::MulAdd(weight.y, q.y, hn::Mul(weight.z, q.z)));
        const Floats sense = hn::Add(weight.x, hn::Add(weight.y, weight.z));
        const Floats turned = hn::IfThenElse(hn::Gt(sense, hn::Zero(Tag())), sum, hn::Neg(sum));
        const Floats size = hn::Add(hn::Abs(q.x), hn::Add(hn::Abs(q.y), hn::Abs(q.z)));
        return hn::Gt(turned, hn::Mul(hn::Add(doubt, doubt), size));
    }

    int kx_, ky_, kz_;
    Floats origin_x_, origin_y_, origin_z_, slope_x_, slope_y_, forward_;
    float speed_;
    std::uint32_t left_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
