// Which spheres of a cell a ray could hit: tested in float, four at once. Whatever the kernel would
// hit passes; what passes is for the kernel to decide.
#pragma once

#include "core/intersect/frame.h"
#include "core/numerics/rounding.h"
#include "native_accel/grid/lanes.h"
#include "native_accel/grid/overlap.h"

namespace etalon {

/// Up to four spheres in the frame, rounded to float.
struct alignas(16) SpherePack {
    using Item = SphereItem;
    static constexpr double cost = 1;

    /// No lane is taken: no distance is below a limit of -1.
    SpherePack() : centre{}, limit(broadcast(-1)) {}

    void set(std::size_t lane, const SphereItem& item);

    std::array<Float4, 3> centre;
    Float4 limit;  ///< what the squared distance of a ray from the centre must not be above
};

/// The distance of a centre from the ray, as a vector in a plane across the ray. Its error, for
/// u = 2^-24, |c| <= sqrt(3), |o| <= 3 sqrt(3) and so |c - o| <= 7, is less than 40 u:
///   the ray's origin and direction are off by 3.7 u and 7 u;
///   each of two coordinates is off by 6.1 u for its axis, which is off by 0.87 u; 0.9 u for the
///     centre; 4 u for the origin's coordinate; 5.2 u for three products and two sums of at most
///     sqrt(3), and u for the last difference, at most the radius: 17.2 u, of both 24.4 u;
///   2 u for the roundings of squares and sum, as the distance is at most the radius.
class SphereFilter {
  public:
    explicit SphereFilter(const FrameRay& ray) {
        const Vec3 d(ray.direction), o(ray.origin);
        Vec3 u, v;
        orthonormal_basis(d / std::sqrt(d.dot(d)), u, v);
        const Vec3f uf(u), vf(v);
        for (int k = 0; k < 3; ++k) {
            u_[k] = broadcast(uf[k]);
            v_[k] = broadcast(vf[k]);
        }
        origin_u_ = broadcast(static_cast<float>(Vec3(uf).dot(o)));
        origin_v_ = broadcast(static_cast<float>(Vec3(vf).dot(o)));
    }

    /// For a sphere of this radius in the frame.
    static float limit(double radius) {
        const double reach = radius + 40 * unit_roundoff_f;
        return float_up(reach * reach);
    }

    Mask4 candidates(const SpherePack& pack, float) const {
        const auto& [x, y, z] = pack.centre;
        const Float4 p = x * u_[0] + y * u_[1] + z * u_[2] - origin_u_;
        const Float4 q = x * v_[0] + y * v_[1] + z * v_[2] - origin_v_;
        return p * p + q * q <= pack.limit;
    }

  private:
    std::array<Float4, 3> u_, v_;
    Float4 origin_u_, origin_v_;
};

inline void SpherePack::set(std::size_t lane, const SphereItem& item) {
    for (int k = 0; k < 3; ++k) centre[k][lane] = static_cast<float>(item.centre[k]);
    limit[lane] = SphereFilter::limit(item.radius);
}

}  // namespace etalon
