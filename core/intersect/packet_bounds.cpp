#include "core/intersect/packet_bounds.h"

#include <algorithm>
#include <bit>
#include <cmath>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/packet_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

struct IntervalLanes {
    HWY_INLINE IntervalLanes() : IntervalLanes(broadcast(infinity), broadcast(-infinity)) {}
    HWY_INLINE IntervalLanes(Doubles least_of, Doubles most_of) : least(least_of), most(most_of) {}
    HWY_INLINE explicit IntervalLanes(const PacketBounds::Interval& i)
        : IntervalLanes(broadcast(i.least), broadcast(i.most)) {}

    HWY_INLINE void extend(Doubles x) {
        least = hn::Min(least, x);
        most = hn::Max(most, x);
    }

    HWY_INLINE PacketBounds::Interval over_lanes() const {
        return {hn::GetLane(hn::MinOfLanes(DoubleTag(), least)),
                hn::GetLane(hn::MaxOfLanes(DoubleTag(), most))};
    }

    HWY_INLINE Doubles magnitude() const { return hn::Max(hn::Abs(least), hn::Abs(most)); }

    Doubles least, most;
};

HWY_INLINE IntervalLanes product(const IntervalLanes& a, const IntervalLanes& b) {
    const Doubles w = a.least * b.least, x = a.least * b.most, y = a.most * b.least,
                  z = a.most * b.most;
    return {hn::Min(hn::Min(w, x), hn::Min(y, z)), hn::Max(hn::Max(w, x), hn::Max(y, z))};
}

PacketBounds::Intervals packet_intervals(const RayPacket& packet) {
    const DoubleTag tag;
    const auto& origins = packet.origins;
    const auto& directions = packet.directions;
    const std::array along{directions.x, directions.y, directions.z};
    const std::array from{origins.x, origins.y, origins.z};
    IntervalLanes origin[3], slope[3];
    for (std::size_t i = 0; i < packet.count; i += hn::Lanes(tag)) {
        const DoubleMask is_ray = hn::FirstN(tag, packet.count - i);
        const auto column = [&](const double* values) HWY_ATTR {
            return hn::IfThenElse(is_ray, hn::LoadU(tag, values + i), broadcast(values[i]));
        };
        const Doubles forward = broadcast(1) / column(along[packet.dominant]);
        for (int k = 0; k < 3; ++k) {
            origin[k].extend(column(from[k]));
            slope[k].extend(k == packet.dominant ? forward : column(along[k]) * forward);
        }
    }
    PacketBounds::Intervals all;
    for (int k = 0; k < 3; ++k) {
        all.origins[k] = origin[k].over_lanes();
        all.slopes[k] = slope[k].over_lanes();
    }
    return all;
}

/// Tests the bounds of a packet whose rays go one way against several boxes.
///
/// A side takes fewer than ten roundings, each at most 2^-53 of `size`, the sum of the operands'
/// magnitudes. The rest of the margin covers what a kernel may still hit. Infinite operands have an
/// infinite margin.
struct BoundsLanes {
    HWY_INLINE BoundsLanes(const PacketBounds::Intervals& all, int dominant_axis, bool up)
        : z(dominant_axis),
          x((z + 1) % 3),
          y((z + 2) % 3),
          goes_up(up),
          origin_x(all.origins[x]),
          origin_y(all.origins[y]),
          origin_z(all.origins[z]),
          slope_x(all.slopes[x]),
          slope_y(all.slopes[y]) {}

    HWY_INLINE static IntervalLanes side(const BoxColumns& boxes, int axis, std::size_t i) {
        return {hn::LoadU(DoubleTag(), boxes.mins(axis) + i),
                hn::LoadU(DoubleTag(), boxes.maxs(axis) + i)};
    }

    HWY_INLINE static DoubleMask passes(const IntervalLanes& origin, const IntervalLanes& slope,
                                        const IntervalLanes& way, const IntervalLanes& side,
                                        Doubles way_size) {
        const IntervalLanes shift = product(slope, way);
        const Doubles size = side.magnitude() + origin.magnitude() + way_size;
        const Doubles room = broadcast(PacketBounds::margin) * size;
        return hn::Or(origin.most +
                      shift.most<side.least - room, origin.least + shift.least> side.most + room);
    }

    HWY_INLINE DoubleMask misses(const BoxColumns& boxes, std::size_t i) const {
        const IntervalLanes depth = side(boxes, z, i);
        const Doubles size = depth.magnitude() + origin_z.magnitude();
        const Doubles room = broadcast(PacketBounds::margin) * size;
        IntervalLanes way(depth.least - origin_z.most, depth.most - origin_z.least);
        const DoubleMask is_behind = goes_up ? way.most < hn::Neg(room) : way.least > room;
        if (goes_up) {
            way.least = hn::Max(way.least, hn::Neg(room));
        } else {
            way.most = hn::Min(way.most, room);
        }
        return hn::Or(is_behind, hn::Or(passes(origin_x, slope_x, way, side(boxes, x, i), size),
                                        passes(origin_y, slope_y, way, side(boxes, y, i), size)));
    }

    int z, x, y;
    bool goes_up;
    IntervalLanes origin_x, origin_y, origin_z, slope_x, slope_y;
};

std::size_t find_near(const PacketBounds::Intervals& all, int dominant, bool goes_up,
                      const BoxColumns& boxes, std::uint32_t* numbers) {
    const DoubleTag tag;
    const BoundsLanes bounds(all, dominant, goes_up);
    std::size_t count = 0;
    for (std::size_t i = 0; i < boxes.size(); i += hn::Lanes(tag)) {
        const DoubleMask is_near =
            hn::AndNot(bounds.misses(boxes, i), hn::FirstN(tag, boxes.size() - i));
        std::uint8_t bits = 0;
        hn::StoreMaskBits(tag, is_near, &bits);
        for (std::uint32_t left = bits; left != 0; left &= left - 1) {
            numbers[count++] = static_cast<std::uint32_t>(i) + std::countr_zero(left);
        }
    }
    return count;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(packet_intervals);
HWY_EXPORT(find_near);

PacketBounds::PacketBounds(const RayPacket& packet)
    : dominant_(packet.dominant), all_(HWY_DYNAMIC_DISPATCH(packet_intervals)(packet)) {
    const Interval& forward = all_.slopes[dominant_];
    goes_up_ = forward.least > 0;
    goes_down_ = forward.most < 0;
}

std::size_t PacketBounds::find_near(const BoxColumns& boxes, std::uint32_t* numbers) const {
    return HWY_DYNAMIC_DISPATCH(find_near)(all_, dominant_, goes_up_, boxes, numbers);
}

}  // namespace etalon
#endif
