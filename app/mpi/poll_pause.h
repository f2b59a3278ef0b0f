#pragma once

#include <chrono>

namespace etalon {

/// Time between two looks for a message where there was none.
inline constexpr auto poll_pause = std::chrono::microseconds(500);

}  // namespace etalon
