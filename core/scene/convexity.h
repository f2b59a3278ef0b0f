#pragma once

#include <cstdint>

namespace etalon {

/// Property of all shapes of a kind: a ray that leaves one to the outside (convex), or to either
/// side (flat), does not hit it again.
enum class Convexity : std::uint8_t { any, convex, flat };

}  // namespace etalon
