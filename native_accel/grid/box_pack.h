// Which shapes of a cell a ray could hit, by their boxes: tested in float, four at once.
#pragma once

#include "core/intersect/frame.h"
#include "native_accel/grid/overlap.h"
#include "native_accel/grid/ray.h"

namespace etalon {

/// Up to four padded boxes.
struct alignas(16) BoxPack {
    using Item = BoxItem;
    static constexpr double cost = 3;  ///< with what more often has to be asked of a kernel

    /// No lane is taken: NaN is in no range.
    BoxPack() {
        const Float4 nothing = broadcast(std::numeric_limits<float>::quiet_NaN());
        low.fill(nothing);
        high.fill(nothing);
    }

    void set(std::size_t lane, const BoxItem& item) {
        for (int k = 0; k < 3; ++k) {
            low[k][lane] = item.box.min[k];
            high[k][lane] = item.box.max[k];
        }
    }

    std::array<Float4, 3> low, high;
};

/// Slab tests. The padding of the boxes (Frame::box) makes up for every rounding here.
class BoxFilter {
  public:
    explicit BoxFilter(const FrameRay& ray) : tmin_(broadcast(-8)) {
        const GridRay r(ray);
        for (int k = 0; k < 3; ++k) {
            origin_[k] = broadcast(r.origin[k]);
            reciprocal_[k] = broadcast(r.reciprocal[k]);
        }
    }

    /// The lanes whose box the ray is in at some t <= tmax.
    Mask4 candidates(const BoxPack& pack, float tmax) const {
        Float4 entry = tmin_, exit = broadcast(tmax);
        for (int k = 0; k < 3; ++k) {
            const Float4 a = (pack.low[k] - origin_[k]) * reciprocal_[k];
            const Float4 b = (pack.high[k] - origin_[k]) * reciprocal_[k];
            entry = max(min(a, b), entry);
            exit = min(max(a, b), exit);
        }
        return (entry <= exit) & (pack.low[0] == pack.low[0]);
    }

  private:
    Float4 tmin_;
    std::array<Float4, 3> origin_, reciprocal_;
};

}  // namespace etalon
