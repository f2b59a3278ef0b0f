// Conversion of the lights and environments of the Whitted-style formats to physical ones.
#pragma once

#include "core/convert/light_values.h"
#include "core/scene/scene.h"

namespace etalon {

/// Adds the converted lights to the look, with bindings and, for those with an extent, triangles
/// after the other primitives. Lights of these formats have no falloff: a light gets the intensity
/// for which a diffuse surface that faces it, at the point the camera looks at, is as bright as
/// before.
void add_physical_lights(const WhittedLook& from, const Camera& camera, const LightValues& light,
                         Geometry& geometry, PhysicalLook& to);

/// Adds the converted environment: light from all directions.
void add_physical_environment(const Environment& from, const LightValues& light, PhysicalLook& to);

}  // namespace etalon
