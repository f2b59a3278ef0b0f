#pragma once

#include "core/material/point_values.h"

namespace etalon {

/// The material whose bumps the point of a mix shows: the first of its first and so on.
const PhysicalMaterial& shape_giving(const PhysicalMaterial& material,
                                     const std::vector<PhysicalMaterial>& all);

/// Adds the lobes of a material, those of a mix by their parts. What is mixed more often than any
/// sane scene does, as in a ring of mixes, has none.
void add_material(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                  const PointValues& values, LobeList& lobes, int depth = 0);

}  // namespace etalon
