#include "core/intersect/ray_beam.h"

#include <algorithm>
#include <cmath>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/ray_beam.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

struct IntervalLanes {
    HWY_INLINE IntervalLanes() : least(broadcast(infinity)), most(broadcast(-infinity)) {}

    HWY_INLINE void extend(Doubles x) {
        least = hn::Min(least, x);
        most = hn::Max(most, x);
    }

    HWY_INLINE Interval over_lanes() const {
        return {hn::GetLane(hn::MinOfLanes(DoubleTag(), least)),
                hn::GetLane(hn::MaxOfLanes(DoubleTag(), most))};
    }

    Doubles least, most;
};

BeamIntervals beam_intervals(const RayGroup& group) {
    const DoubleTag tag;
    const auto& origins = group.origins;
    const auto& directions = group.directions;
    const std::array along{directions.x.data(), directions.y.data(), directions.z.data()};
    const std::array from{origins.x.data(), origins.y.data(), origins.z.data()};
    IntervalLanes origin[3], slope[3];
    for (std::size_t i = 0; i < group.count; i += hn::Lanes(tag)) {
        const DoubleMask is_ray = hn::FirstN(tag, group.count - i);
        const auto column = [&](const double* values) HWY_ATTR {
            return hn::IfThenElse(is_ray, hn::LoadU(tag, values + i), broadcast(values[i]));
        };
        const Doubles forward = broadcast(1) / column(along[group.dominant]);
        for (int k = 0; k < 3; ++k) {
            origin[k].extend(column(from[k]));
            slope[k].extend(k == group.dominant ? forward : column(along[k]) * forward);
        }
    }
    BeamIntervals all;
    for (int k = 0; k < 3; ++k) {
        all.origins[k] = origin[k].over_lanes();
        all.slopes[k] = slope[k].over_lanes();
    }
    return all;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(beam_intervals);

namespace {

double magnitude(const Interval& i) {
    return std::max(std::abs(i.least), std::abs(i.most));
}

Interval sum(const Interval& a, const Interval& b) {
    return {a.least + b.least, a.most + b.most};
}

Interval product(const Interval& a, const Interval& b) {
    const auto [least, most] =
        std::minmax({a.least * b.least, a.least * b.most, a.most * b.least, a.most * b.most});
    return {least, most};
}

/// Whether intervals lie apart, by more than what roundings of numbers of `size` may hide.
bool are_apart(const Interval& a, const Interval& b, double size) {
    const double room = RayBeam::margin * size;
    return a.most < b.least - room || a.least > b.most + room;
}

}  // namespace

RayBeam::RayBeam(const RayGroup& group)
    : dominant_(group.dominant), all_(HWY_DYNAMIC_DISPATCH(beam_intervals)(group)) {
    // Reciprocals in this range are as good as any number, and so are slopes made with them.
    constexpr double largest = 0x1p1001;
    const Interval& forward = all_.slopes[dominant_];
    goes_up_ = forward.least > 1 / largest && forward.most < largest;
    goes_down_ = forward.most < -1 / largest && forward.least > -largest;
}

/// Of the roundings, fewer than ten, none is more than 2^-53 of `size`, a sum of the magnitudes
/// that enter. What a kernel still hits is within the rest of the margin.
bool RayBeam::surely_misses(const Box3& box) const {
    const Interval& start = all_.origins[dominant_];
    const Interval side{box.min[dominant_], box.max[dominant_]};
    const double size = magnitude(side) + magnitude(start), room = margin * size;
    Interval way = sum(side, {-start.most, -start.least});
    if (goes_up_) {
        if (way.most < -room) return true;
        way.least = std::max(way.least, -room);
    } else if (goes_down_) {
        if (way.least > room) return true;
        way.most = std::min(way.most, room);
    } else {
        return false;
    }
    for (const int k : {(dominant_ + 1) % 3, (dominant_ + 2) % 3}) {
        const Interval there = sum(all_.origins[k], product(all_.slopes[k], way));
        const Interval sides{box.min[k], box.max[k]};
        const double all_sizes = magnitude(sides) + magnitude(all_.origins[k]) + size;
        if (are_apart(there, sides, all_sizes)) return true;
    }
    return false;
}

}  // namespace etalon
#endif
