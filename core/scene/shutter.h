#pragma once

#include <cstdint>

namespace etalon {

/// Time at which a ray sees the scene, as a fraction of the shutter interval in units of 2^-24:
/// from 0, where the shutter opens, to below 2^24. As fine as the numbers of a float.
using ShutterTime = std::uint32_t;

inline constexpr int shutter_time_bits = 24;
inline constexpr ShutterTime last_shutter_time = (ShutterTime{1} << shutter_time_bits) - 1;

/// Returns the time for a number in [0, 1), of which the first 24 bits count.
inline ShutterTime shutter_time(double part) {
    return static_cast<ShutterTime>(part * 0x1p24) & last_shutter_time;
}

/// Times of the keyframes of a motion and of the shutter, on one clock.
struct MotionTimes {
    double start = 0, end = 1;
    double shutter_open = 0, shutter_close = 1;

    /// Returns the fraction of the motion that is done at a time of the shutter, in [0, 1].
    double part(ShutterTime time) const {
        const double now = shutter_open + time * 0x1p-24 * (shutter_close - shutter_open);
        if (now <= start) return 0;
        if (now >= end) return 1;
        return (now - start) / (end - start);
    }

    /// Returns whether the shutter interval contains more than one moment of the motion.
    bool see_motion() const { return part(0) != part(last_shutter_time); }
};

}  // namespace etalon
