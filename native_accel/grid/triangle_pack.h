// Which triangles of a cell a ray could hit: tested in float, four at once. Whatever the kernel
// would hit passes; what passes is for the kernel to decide.
#pragma once

#include "core/intersect/frame.h"
#include "core/numerics/rounding.h"
#include "native_accel/grid/lanes.h"
#include "native_accel/grid/overlap.h"

namespace etalon {

/// Up to four triangles in the frame, rounded to float.
struct alignas(16) TrianglePack {
    using Item = TriangleItem;
    static constexpr double cost = 1.5;

    /// No lane is taken: NaN for corners, which no ray meets.
    TrianglePack() : doubt{} {
        for (auto& corner : corners) {
            corner.fill(broadcast(std::numeric_limits<float>::quiet_NaN()));
        }
    }

    void set(std::size_t lane, const TriangleItem& item);

    std::array<std::array<Float4, 3>, 3> corners;  ///< of each corner x, y and z
    Float4 doubt;                                  ///< bound on the error of an edge function
};

/// The edge functions of Woop, Benthin & Wald 2013 (JCGT 2(1)) with a bound on their errors, for
/// u = 2^-24, corners |p| <= 1 and origins |o| <= 3, so |p - o| <= 4.
///
/// A sheared coordinate x = (px - s pz) - (ox - s oz), s = dx / dz, |s| <= 1, is off by
///   4.2 u for the origin, u for the corner;
///   12.1 u for the slope, in whose components and quotient there are u each, times |pz - oz|;
///   0.5 u for s pz, u for the first difference, of at most 2, and 4 u for ox - s oz, of at most 6;
///   2 u for the last difference, which is at most twice the triangle's extent where the ray meets
///   it. Together 24.8 u: less than E = 25 u.
///
/// An edge function U = x1 y2 - y1 x2 of a triangle that the ray's line meets: it surrounds the
/// line, so with L its largest extent along an axis |x|, |y| <= X = 2 L. U is off by
/// 4 X E + 2 E^2 from its inputs and 4 u (X + E)^2 <= 0.65 E (X + E) from its roundings, as X <= 4:
/// less than 9.3 E L + 2.7 E^2.
class TrianglePackFilter {
  public:
    explicit TrianglePackFilter(const FrameRay& ray) {
        kz_ = dominant_axis(Vec3(ray.direction));
        kx_ = (kz_ + 1) % 3;
        ky_ = (kz_ + 2) % 3;
        const float sx = ray.direction[kx_] / ray.direction[kz_];
        const float sy = ray.direction[ky_] / ray.direction[kz_];
        const double z = ray.origin[kz_];
        slope_x_ = broadcast(sx);
        slope_y_ = broadcast(sy);
        origin_x_ = broadcast(static_cast<float>(ray.origin[kx_] - sx * z));
        origin_y_ = broadcast(static_cast<float>(ray.origin[ky_] - sy * z));
    }

    /// For a triangle of so large an extent in the frame.
    static float doubt(double extent) {
        constexpr double e = 25 * unit_roundoff_f;
        return float_up(e * (9.3 * (extent + unit_roundoff_f) + 3 * e));
    }

    Mask4 candidates(const TrianglePack& pack, float) const {
        const Corner a = shear(pack.corners[0]), b = shear(pack.corners[1]),
                     c = shear(pack.corners[2]);
        const Float4 u = edge(b, c), v = edge(c, a), w = edge(a, b);
        return (min(u, min(v, w)) >= -pack.doubt) | (max(u, max(v, w)) <= pack.doubt);
    }

  private:
    struct Corner {
        Float4 x, y;
    };

    Corner shear(const std::array<Float4, 3>& p) const {
        return {(p[kx_] - slope_x_ * p[kz_]) - origin_x_, (p[ky_] - slope_y_ * p[kz_]) - origin_y_};
    }

    static Float4 edge(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }

    int kx_, ky_, kz_;
    Float4 slope_x_, slope_y_, origin_x_, origin_y_;
};

inline void TrianglePack::set(std::size_t lane, const TriangleItem& item) {
    Box3f box;
    for (int c = 0; c < 3; ++c) {
        box.extendBy(item.corners[c]);
        for (int k = 0; k < 3; ++k) corners[c][k][lane] = item.corners[c][k];
    }
    doubt[lane] = TrianglePackFilter::doubt(max_abs(Vec3(box.max) - Vec3(box.min)));
}

}  // namespace etalon
