// Lights without extent: point lights that shine in all directions, in a cone or through an image,
// and directional lights.
#pragma once

#include "core/light/light_sample.h"
#include "core/light/spherical_image.h"
#include "core/scene/physical_light.h"

namespace etalon {

/// Returns what such a light sends to a point; pdf 0 for other lights. `image` is the light's
/// image, if it has one.
LightSample sample_delta_light(const PhysicalLight& light, const SphericalImage* image,
                               const Vec3& from);

/// Returns the power of such a light as a luminance, for the choice of lights; 0 for other lights.
/// That of a distant light comes through a disk of the scene's radius.
double delta_light_power(const PhysicalLight& light, const SphericalImage* image,
                         double scene_radius);

/// Returns half of the sides of a projection's window in the plane z = 1.
Vec2 half_window(const ProjectionSource& light, const SphericalImage& image);

}  // namespace etalon
