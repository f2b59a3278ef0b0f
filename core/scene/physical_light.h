// Sources of light by physical rules. Plain data; core/light samples them.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/numerics/affine.h"
#include "core/scene/environment.h"
#include "core/scene/shapes.h"

namespace etalon {

struct PointSource {
    Vec3 position;
    Color intensity;  ///< in all directions, per steradian
};

/// A point that shines into a cone, with a smooth border.
struct SpotSource {
    Vec3 position, axis;  ///< axis of unit length
    Color intensity;
    double cos_total, cos_falloff;  ///< nothing beyond the first angle, all within the second
};

/// A point whose intensity varies with the direction as an image says: see InfiniteSource, but with
/// y and z of the light's space exchanged.
struct GoniometricSource {
    Vec3 position;
    Color intensity;
    std::string image;
    Affine to_light;  ///< from the world's directions to the light's
};

/// A point that throws an image, as a slide projector does, along z of its own space: on a
/// window of the plane z = 1 about the axis, with the image's aspect and its first row at the least
/// y. Without an image a square is lit evenly.
struct ProjectionSource {
    Vec3 position;
    Color intensity;
    std::string image;
    Affine to_light;      ///< from the world's directions to the light's
    double half_tangent;  ///< half of the shorter side of the window
};

/// Light from one direction at infinity.
struct DistantSource {
    Vec3 direction;  ///< unit vector towards the light
    Color radiance;
};

/// Light from all around. With an image: its rows are the angles from +z of the light's own space,
/// its columns the angles about it.
struct InfiniteSource {
    Color radiance;
    std::string image{};
    Affine to_light{};                    ///< from the world's directions to the light's
    int samples = 1;                      ///< how many a vertex takes where every light is asked
    std::optional<Environment> skybox{};  ///< what is seen instead of all the above
    bool decode_srgb = false;             ///< the skybox is of display values
};

/// A primitive that shines from its front, or from both sides.
struct AreaSource {
    std::uint32_t primitive;
    Color radiance;
    bool two_sided;
    int samples = 1;  ///< how many a vertex takes where every light is asked
};

using PhysicalLight = std::variant<PointSource, SpotSource, GoniometricSource, ProjectionSource,
                                   DistantSource, InfiniteSource, AreaSource>;

}  // namespace etalon
