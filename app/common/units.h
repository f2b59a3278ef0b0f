// Formatting of quantities in messages.
#pragma once

#include <cstdint>
#include <string>

namespace etalon {

/// Returns "1,411,230".
std::string grouped(std::uint64_t n);

/// Returns "1,536 rays", "12.34 Mrays".
std::string rays_text(std::uint64_t rays);

/// Returns "1.2 ms", "12.34 s".
std::string seconds_text(double seconds);

}  // namespace etalon
