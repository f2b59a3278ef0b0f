// Conversion of the materials of the Whitted-style formats to physical ones.
#pragma once

#include <cstdint>
#include <vector>

#include "core/convert/light_values.h"
#include "core/scene/material.h"
#include "core/scene/physical_material.h"

namespace etalon {

/// Appends the converted material, and before it the parts of a mix. Returns its number.
std::uint32_t add_physical(const Material& material, const LightValues& light,
                           std::vector<PhysicalMaterial>& to);

}  // namespace etalon
