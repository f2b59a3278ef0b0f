#pragma once

#include <cstdint>

namespace etalon {

/// How many rays of each kind an image took. The same for every backend and thread count.
struct RayCounts {
    std::uint64_t camera = 0, camera_hits = 0;
    std::uint64_t shadow = 0, shadow_blocked = 0;  ///< asked only whether anything is in the way
    std::uint64_t reflected = 0, refracted = 0;
    std::uint64_t secondary_hits = 0;  ///< hits of reflected and refracted rays

    std::uint64_t total() const { return camera + shadow + reflected + refracted; }
    RayCounts& operator+=(const RayCounts& other);
    bool operator==(const RayCounts&) const = default;
};

}  // namespace etalon
