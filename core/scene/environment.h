#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/numerics/vec.h"

namespace etalon {

/// Six square images around the scene. Seen from inside, +X is *left*, +Y top and +Z front (the
/// convention of Humus' cube maps). Face k belongs to -X, +X, +Y, -Y, +Z, -Z.
struct Skybox {
    std::array<std::string, 6> faces;  ///< files: right, left, top, bottom, front, back
    bool nearest = false;              ///< nearest texel instead of bilinear
};

/// Surroundings of the scene, seen by rays that leave it.
struct Environment {
    Color background{0.0F};
    std::optional<Skybox> skybox;
};

}  // namespace etalon
