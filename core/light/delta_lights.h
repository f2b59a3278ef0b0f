// Lights without extent: points that shine in all directions, in a cone, by an image, and light
// from afar.
#pragma once

#include "core/light/light_sample.h"
#include "core/light/spherical_image.h"
#include "core/scene/physical_light.h"

namespace etalon {

/// What such a light sends to a point; pdf 0 of other lights. `image` is its image, of those that
/// have one.
LightSample sample_delta_light(const PhysicalLight& light, const SphericalImage* image,
                               const Vec3& from);

/// Half of the sides of a projection's window in the plane z = 1.
Vec2 half_window(const ProjectionSource& light, const SphericalImage& image);

}  // namespace etalon
