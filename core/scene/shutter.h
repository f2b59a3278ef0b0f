#pragma once

#include <cstdint>

namespace etalon {

/// Time at which a ray sees the scene, in parts of the time that the shutter is open: from 0, where
/// it opens, to before 2^24. As fine as the numbers of a float.
using ShutterTime = std::uint32_t;

inline constexpr int shutter_time_bits = 24;
inline constexpr ShutterTime last_shutter_time = (ShutterTime{1} << shutter_time_bits) - 1;

/// Returns the time for a number in [0, 1), of which the first 24 bits count.
inline ShutterTime shutter_time(double part) {
    return static_cast<ShutterTime>(part * 0x1p24) & last_shutter_time;
}

/// When something moves, and when the shutter is open, on one clock.
struct MotionTimes {
    double start = 0, end = 1;
    double shutter_open = 0, shutter_close = 1;

    /// Returns how much of the motion is done at a time of the shutter, in [0, 1].
    double part(ShutterTime time) const {
        const double now = shutter_open + time * 0x1p-24 * (shutter_close - shutter_open);
        if (now <= start) return 0;
        if (now >= end) return 1;
        return (now - start) / (end - start);
    }

    /// Returns whether the shutter sees more than one moment of the motion.
    bool see_motion() const { return part(0) != part(last_shutter_time); }
};

}  // namespace etalon
