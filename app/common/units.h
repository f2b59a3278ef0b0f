// Quantities as messages show them.
#pragma once

#include <cstdint>
#include <string>

namespace etalon {

/// "1,411,230".
std::string grouped(std::uint64_t n);

/// "1,536 rays", "12.34 Mrays".
std::string rays_text(std::uint64_t rays);

/// "1.2 ms", "12.34 s".
std::string seconds_text(double seconds);

}  // namespace etalon
