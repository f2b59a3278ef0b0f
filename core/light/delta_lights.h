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

/// Returns half of the sides of a projection's window in the plane z = 1.
Vec2 half_window(const ProjectionSource& light, const SphericalImage& image);

}  // namespace etalon
