#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/write/conversion_warnings.h"
#include "core/scene/material.h"
#include "core/scene/physical_material.h"

namespace etalon {

/// Adds warnings for properties of a Whitted-style material that its physical one lacks.
void warn_of_losses(const Material& material, ConversionWarnings& lost);

/// Returns PBRT v3's directive for material `number` of the list, made by add_physical(), under the
/// name "m<number>". A mix refers to its parts by their names.
std::string to_pbrt(const std::vector<PhysicalMaterial>& materials, std::uint32_t number);

}  // namespace etalon
