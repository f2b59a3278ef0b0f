// Items of grids, and the cells that they really overlap: a shape can be far smaller than its box.
#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// An item of which only the box is known. All in normalized space.
struct BoxItem {
    Box3f box;
    std::uint32_t id;
};

struct SphereItem {
    Box3f box;
    std::uint32_t id;  ///< number in Geometry::primitives
    Vec3 centre;
    double radius;
};

/// Has touches(): returns whether an item has, or might have, a point in common with a box of the
/// given centre and half size. False only if they are apart by more than the roundings of doubles.
template <class Item>
class Overlap;

template <>
class Overlap<BoxItem> {
  public:
    Overlap(const BoxItem&, const Vec3&) {}
    bool touches(const Vec3&) const { return true; }
};

template <>
class Overlap<SphereItem> {
  public:
    Overlap(const SphereItem& item, const Vec3& half_size)
        : centre_(item.centre), half_(half_size), radius2_(item.radius * item.radius) {}

    bool touches(const Vec3& centre) const {
        double distance2 = 0;
        for (int k = 0; k < 3; ++k) {
            const double d = std::max(std::abs(centre[k] - centre_[k]) - half_[k], 0.0);
            distance2 += d * d;
        }
        return distance2 <= radius2_;
    }

  private:
    Vec3 centre_, half_;
    double radius2_;
};

}  // namespace etalon
