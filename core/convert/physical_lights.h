// Lights and surroundings of the Whitted-style formats as physical ones.
#pragma once

#include "core/convert/light_values.h"
#include "core/scene/scene.h"

namespace etalon {

/// Adds what the lights become to the look, with bindings and, for those with an extent, triangles
/// after the other primitives. A light has no falloff in these formats: it gets the intensity with
/// which a diffuse surface that faces it at the point looked at is as bright as it was.
void add_physical_lights(const WhittedLook& from, const Camera& camera, const LightValues& light,
                         Geometry& geometry, PhysicalLook& to);

/// Adds what the surroundings become: a light all around.
void add_physical_environment(const Environment& from, const LightValues& light, PhysicalLook& to);

}  // namespace etalon
