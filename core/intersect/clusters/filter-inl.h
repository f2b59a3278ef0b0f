// Which primitives of a cluster a ray could hit: tested in float, eight at once. Whatever the
// kernel would hit passes; what passes is for the kernel to decide. Compiled for each instruction
// set.
#if defined(ETALON_CLUSTERS_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_CLUSTERS_FILTER_INL_H
#undef ETALON_CLUSTERS_FILTER_INL_H
#else
#define ETALON_CLUSTERS_FILTER_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "core/intersect/clusters/clusters.h"
#include "core/intersect/clusters/doubt.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, cluster_lanes>;
using Floats = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

/// Of a mask of the lanes from `first` on.
HWY_INLINE std::uint32_t bits(Mask mask, std::size_t first) {
    std::uint8_t byte = 0;
    hn::StoreMaskBits(Tag(), mask, &byte);
    return static_cast<std::uint32_t>(byte) << first;
}

HWY_INLINE Floats broadcast(float x) {
    return hn::Set(Tag(), x);
}
HWY_INLINE Floats load(const Lanes& lanes, std::size_t first) {
    return hn::Load(Tag(), &lanes[first]);
}

/// By edge functions.
class TriangleFilter {
  public:
    HWY_INLINE explicit TriangleFilter(const FrameRay& ray) {
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
        std::uint32_t found = 0;
        for (std::size_t i = 0; i < cluster_lanes; i += hn::MaxLanes(Tag())) {
            found |= bits(meets(cluster, i, tmax), i);
        }
        return found;
    }

  private:
    struct Corner {
        Floats x, y, z;
    };

    HWY_INLINE Mask meets(const TriangleCluster& cluster, std::size_t i, float tmax) const {
        const Corner a = shear(cluster.corners[0], i), b = shear(cluster.corners[1], i),
                     c = shear(cluster.corners[2], i);
        const Floats doubt = broadcast(cluster.doubt);
        const Floats u = edge(b, c), v = edge(c, a), w = edge(a, b);
        const Mask surrounds = hn::Or(hn::Ge(hn::Min(u, hn::Min(v, w)), hn::Neg(doubt)),
                                      hn::Le(hn::Max(u, hn::Max(v, w)), doubt));
        if (hn::AllFalse(Tag(), surrounds)) return surrounds;
        return hn::AndNot(surely_beyond(tmax, {u, v, w}, {a.z, b.z, c.z}, doubt), surrounds);
    }

    HWY_INLINE Corner shear(const std::array<Lanes, 3>& p, std::size_t i) const {
        const Floats z = hn::Sub(load(p[kz_], i), origin_z_);
        return {hn::NegMulAdd(slope_x_, z, hn::Sub(load(p[kx_], i), origin_x_)),
                hn::NegMulAdd(slope_y_, z, hn::Sub(load(p[ky_], i), origin_y_)), z};
    }

    static HWY_INLINE Floats edge(const Corner& a, const Corner& b) {
        return hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x));
    }

    /// The hit is at the mean of the corners' depths, weighted by |U|, |V|, |W|. It is beyond the
    /// depth of tmax if the sum of |U| q is positive, q being each corner's depth less that. What
    /// is computed is off by doubt * (sum of |q|), with the share of the doubt that is kept for the
    /// roundings of this sum, 3 u |U| <= 24 u L^2 <= 48 u L < 1.8 E L. Where the sign of U + V + W
    /// is wrong none of the three is beyond twice the doubt in size, nor is the sum.
    HWY_INLINE Mask surely_beyond(float tmax, const Corner& weight, const Corner& depth,
                                  Floats doubt) const {
        const Floats limit = broadcast(std::clamp(tmax * speed_, -8.0F, 8.0F) + depth_doubt);
        const Floats qx = hn::MulSub(forward_, depth.x, limit),
                     qy = hn::MulSub(forward_, depth.y, limit),
                     qz = hn::MulSub(forward_, depth.z, limit);
        const Floats sum =
            hn::MulAdd(weight.x, qx, hn::MulAdd(weight.y, qy, hn::Mul(weight.z, qz)));
        const Floats sense = hn::Add(weight.x, hn::Add(weight.y, weight.z));
        const Floats turned = hn::IfThenElse(hn::Gt(sense, hn::Zero(Tag())), sum, hn::Neg(sum));
        const Floats size = hn::Add(hn::Abs(qx), hn::Add(hn::Abs(qy), hn::Abs(qz)));
        return hn::Gt(turned, hn::Mul(hn::Add(doubt, doubt), size));
    }

    int kx_, ky_, kz_;
    Floats origin_x_, origin_y_, origin_z_, slope_x_, slope_y_, forward_;
    float speed_;
};

/// By the distance between the ray's line and the centre.
class SphereFilter {
  public:
    HWY_INLINE SphereFilter(const FrameRay& ray, float tmin) : tmin_(tmin) {
        for (int k = 0; k < 3; ++k) {
            origin_[k] = broadcast(ray.origin[k]);
            direction_[k] = broadcast(ray.direction[k]);
        }
        reciprocal_ = broadcast(1 / ray.direction.dot(ray.direction));
    }

    /// The lanes, lowest first, that the ray could hit at tmin < t <= tmax in the frame.
    HWY_INLINE std::uint32_t candidates(const SphereCluster& cluster, float tmax) const {
        std::uint32_t found = 0;
        for (std::size_t i = 0; i < cluster_lanes; i += hn::MaxLanes(Tag())) {
            found |= bits(meets(cluster, i, tmax), i);
        }
        return found;
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
        return hn::And(hn::Ge(reach, zero), hn::Le(hn::Mul(gap, gap), reach));
    }

    static HWY_INLINE Floats dot(Floats ax, Floats ay, Floats az, Floats bx, Floats by, Floats bz) {
        return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, hn::Mul(az, bz)));
    }

    std::array<Floats, 3> origin_, direction_;
    Floats reciprocal_;
    float tmin_;
};

/// Whatever a cluster holds.
class ClusterFilter {
  public:
    HWY_INLINE ClusterFilter(const FrameRay& ray, float tmin)
        : triangles_(ray), spheres_(ray, tmin) {}

    /// The lanes, lowest first, that the ray could hit at tmin < t <= tmax in the frame; all those
    /// of a list, taken or not.
    HWY_INLINE std::uint32_t candidates(const Clusters& clusters, ClusterRef ref,
                                        float tmax) const {
        switch (ref.kind()) {
            case ClusterRef::triangles:
                return triangles_.candidates(clusters.triangles(ref), tmax);
            case ClusterRef::spheres:
                return spheres_.candidates(clusters.spheres(ref), tmax);
            default:
                return (1U << cluster_lanes) - 1;
        }
    }

  private:
    TriangleFilter triangles_;
    SphereFilter spheres_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
