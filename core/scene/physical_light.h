// Physical light sources. Plain data; core/light samples them.
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
    Color intensity;  ///< per steradian, the same in all directions
};

/// A spotlight: a point that shines into a cone with a smooth edge.
struct SpotSource {
    Vec3 position, axis;  ///< axis of unit length
    Color intensity;
    double cos_total, cos_falloff;  ///< dark beyond the first angle, full within the second
};

/// A point whose intensity is given for each direction by an image: see InfiniteSource, but with y
/// and z of the light's space exchanged.
struct GoniometricSource {
    Vec3 position;
    Color intensity;
    std::string image;
    Affine to_light;  ///< from the world's directions to the light's
};

/// A point that projects an image along z of its own space: onto a window of the plane z = 1 about
/// the axis, with the image's aspect ratio and its first row at the least y. Without an image a
/// square is lit evenly.
struct ProjectionSource {
    Vec3 position;
    Color intensity;
    std::string image;
    Affine to_light;      ///< maps directions of the world to the light's space
    double half_tangent;  ///< half of the shorter side of the window
};

/// A directional light at infinity.
struct DistantSource {
    Vec3 direction;  ///< unit vector towards the light
    Color radiance;
};

/// Light from all directions. With an image: its rows are the angles from +z of the light's own
/// space, its columns the angles about it.
struct InfiniteSource {
    Color radiance;
    std::string image{};
    Affine to_light{};                    ///< from the world's directions to the light's
    int samples = 1;                      ///< samples of a vertex at which all lights are sampled
    std::optional<Environment> skybox{};  ///< if set, it replaces all the above; of light
};

/// Consecutive primitives, those of one shape, that emit light from their fronts or from both
/// sides. Each of them is sampled as a light of its own.
struct AreaSource {
    std::uint32_t first;  ///< number of the first primitive
    std::uint32_t count;  ///< number of primitives
    Color radiance;
    bool two_sided;
    int samples = 1;  ///< samples of each at a vertex at which all lights are sampled
};

using PhysicalLight = std::variant<PointSource, SpotSource, GoniometricSource, ProjectionSource,
                                   DistantSource, InfiniteSource, AreaSource>;

}  // namespace etalon
