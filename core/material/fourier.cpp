#include "core/material/add_lobes.h"

namespace etalon {

void add_lobes(const FourierMaterial& material, const PointValues&, LobeList& lobes) {
    if (material.table) lobes.add(FourierScattering(*material.table));
}

}  // namespace etalon
