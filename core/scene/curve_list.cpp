#include "core/scene/curve_list.h"

#include <bit>

#include "core/scene/instance.h"
#include "core/scene/map_condition.h"
#include "core/scene/spare_room.h"

namespace etalon {
namespace {

bool same(const Affine& a, const Affine& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.origin == b.origin;
}

}  // namespace

CurveTransform::CurveTransform(const Affine& map)
    : to_world(map), rows(Instance(map, 0).rows), stretch(stretch_of(to_world, rows)) {
    if (!exists()) rows.fill(Vec3(nan_value));  // so that no ray hits it
}

/// An inverse that consists mostly of roundings would map points anywhere, so it does not count.
bool CurveTransform::exists() const {
    constexpr double largest_condition = 0x1p30, largest_stretch = 0x1p50;
    return is_finite(to_world) && condition_of(to_world, rows) < largest_condition &&
           stretch < largest_stretch;
}

void CurveList::push_back(const Curve& c) {
    if (places_.empty() || !same(places_.back().to_world, c.to_world)) {
        places_.emplace_back(c.to_world);
    }
    const auto place = static_cast<std::uint32_t>(places_.size() - 1);
    if (curves_.empty() || curves_.back().place != place || curves_.back().curve != c.curve) {
        curves_.push_back({c.curve, place});
    }
    const auto logarithm = static_cast<std::uint32_t>(std::countr_zero(c.part.count));
    parts_.push_back(
        {static_cast<std::uint32_t>(curves_.size() - 1), logarithm << 16 | c.part.number});
}

void CurveList::shrink_to_fit() {
    release_spare_capacity(parts_);
    release_spare_capacity(curves_);
    release_spare_capacity(places_);
}

std::size_t CurveList::memory_bytes() const {
    return written_bytes(parts_) + written_bytes(curves_) + written_bytes(places_);
}

}  // namespace etalon
