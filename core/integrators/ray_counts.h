#pragma once

#include <cstdint>

namespace etalon {

/// Numbers of an image's rays by kind. The same for every backend and thread count.
struct RayCounts {
    std::uint64_t camera = 0, camera_hits = 0;
    std::uint64_t shadow = 0, shadow_blocked = 0;  ///< occlusion queries
    std::uint64_t reflected = 0, refracted = 0;
    std::uint64_t secondary_hits = 0;  ///< hits of reflected and refracted rays

    std::uint64_t total() const { return camera + shadow + reflected + refracted; }
    RayCounts& operator+=(const RayCounts& other);
    bool operator==(const RayCounts&) const = default;
};

}  // namespace etalon
