// Which triangles of a leaf a ray could hit: tested in float, four at once. Whatever the kernel
// would hit passes; what passes is for the kernel to decide.
#pragma once

#include <algorithm>

#include "core/intersect/frame.h"
#include "core/numerics/rounding.h"
#include "native_accel/bvh/triangle_leaf.h"

namespace etalon {

/// The edge functions of Woop, Benthin & Wald 2013 (JCGT 2(1)) with bounds on their errors, for
/// u = 2^-24 and coordinates of the frame: corners |p| <= 1, origins |o| <= 3, so |p - o| <= 4.
///
/// A sheared coordinate x = (px - ox) - (dx / dz) (pz - oz), |dx / dz| <= 1:
///   px - ox and pz - oz: corner u/2, origin 2.1 u (half a unit in the last place of 3, and what
///     moving it up to 2^24 in double costs), the difference 2 u: 4.6 u each;
///   the slope: dx, dz and the quotient u each, so 3.01 u; times pz - oz 4.6 u + 12.1 u + 2 u;
///   the last difference, of at most 8, 4 u. Together 27.3 u: less than E = 28 u.
///
/// An edge function U = x1 y2 - y1 x2 of a triangle that the ray's line meets: it surrounds the
/// line, so with L its largest extent along an axis |x|, |y| <= X = 2 L. U is off by
/// 4 X E + 2 E^2 from its inputs and 4 u (X + E)^2 <= 0.58 E (X + E) from its roundings, as X <= 4:
/// less than 9.2 E L + 2.6 E^2. Adding 1.8 E L, used below, gives edge_doubt.
class TriangleFilter {
  public:
    explicit TriangleFilter(const FrameRay& ray) {
        kz_ = dominant_axis(Vec3(ray.direction));
        kx_ = (kz_ + 1) % 3;
        ky_ = (kz_ + 2) % 3;
        const float dz = ray.direction[kz_];
        slope_x_ = broadcast(ray.direction[kx_] / dz);
        slope_y_ = broadcast(ray.direction[ky_] / dz);
        for (int k = 0; k < 3; ++k) origin_[k] = broadcast(ray.origin[k]);
        forward_ = broadcast(std::copysign(1.0F, dz));
        speed_ = std::abs(dz);
    }

    /// For a triangle of so large an extent in the frame.
    static float edge_doubt(double extent) {
        constexpr double e = 28 * unit_roundoff_f;
        return float_up(e * (11 * (extent + unit_roundoff_f) + 3 * e));
    }

    /// The lanes that the ray could hit at t <= tmax.
    Mask4 candidates(const TriangleLeaf& leaf, float tmax) const {
        const Corner a = shear(leaf.corners[0]), b = shear(leaf.corners[1]),
                     c = shear(leaf.corners[2]);
        const Float4 u = edge(b, c), v = edge(c, a), w = edge(a, b);
        const Mask4 meets = (min(u, min(v, w)) >= -leaf.doubt) | (max(u, max(v, w)) <= leaf.doubt);
        if (!any(meets)) return meets;
        return meets & ~surely_beyond(tmax, {u, v, w}, {a.z, b.z, c.z}, leaf.doubt);
    }

  private:
    struct Corner {
        Float4 x, y, z;
    };

    Corner shear(const std::array<Float4, 3>& p) const {
        const Float4 z = p[kz_] - origin_[kz_];
        return {(p[kx_] - origin_[kx_]) - slope_x_ * z, (p[ky_] - origin_[ky_]) - slope_y_ * z, z};
    }

    static Float4 edge(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }

    /// A depth that all hits at t <= tmax are in front of, with room for every error of a depth:
    /// dz u and the product u, of at most 8, 16 u; a corner's depth 4.6 u; the differences of two,
    /// of at most 13, 8 u here and there; and 2 u for the kernel, whose t is good to u in the frame
    /// (doubt in distance_of(): at most 2^-26 of the triangle's depth, 2, and 2^-50 of the
    /// distance, 2^24).
    float deepest(float tmax) const {
        constexpr float room = 48 * unit_roundoff_f;
        return std::clamp(tmax * speed_, -8.0F, 8.0F) + room;
    }

    /// The hit is at the mean of the corners' depths, weighted by |U|, |V|, |W|. It is beyond
    /// `deepest` if the sum of |U| q is positive, q being each corner's depth less that. What is
    /// computed is off by doubt * (sum of |q|), with the share of the doubt that is kept for the
    /// roundings of this sum, 3 u |U| <= 24 u L^2 <= 48 u L < 1.8 E L. Where the sign of U + V + W
    /// is wrong none of the three is beyond twice the doubt in size, nor is the sum.
    Mask4 surely_beyond(float tmax, const Corner& weight, const Corner& depth, Float4 doubt) const {
        const Float4 limit = broadcast(deepest(tmax));
        const Float4 qx = forward_ * depth.x - limit, qy = forward_ * depth.y - limit,
                     qz = forward_ * depth.z - limit;
        const Float4 sum = weight.x * qx + weight.y * qy + weight.z * qz;
        const Float4 turned = weight.x + weight.y + weight.z > 0 ? sum : -sum;
        return turned > 2 * doubt * (abs(qx) + abs(qy) + abs(qz));
    }

    int kx_, ky_, kz_;
    std::array<Float4, 3> origin_;
    Float4 slope_x_, slope_y_, forward_;
    float speed_;
};

}  // namespace etalon
