#pragma once

#include "core/material/point_values.h"

namespace etalon {

/// Returns the material whose bump map a mix has: the first of its first and so on.
const PhysicalMaterial& shape_giving(const PhysicalMaterial& material,
                                     const std::vector<PhysicalMaterial>& all);

/// Adds the lobes of a material; those of a mix by its parts. Mixes that are nested deeper than in
/// any sane scene, as in a cycle of mixes, add none.
void add_material(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                  const PointValues& values, LobeList& lobes, int depth = 0);

}  // namespace etalon
