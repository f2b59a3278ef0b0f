#include "core/material/add_lobes.h"

namespace etalon {

void add_lobes(const UberMaterial& material, const PointValues& values, LobeList& lobes) {
    const float eta = values.number(material.eta);
    const Color opacity = values.part(material.opacity);
    const auto missing = [](float part) { return std::max(0.0F, 1 - part); };
    const Color clear(missing(opacity.x), missing(opacity.y), missing(opacity.z));
    if (!is_black(clear)) lobes.add(SpecularTransmission{clear, 1});

    const Color kd = opacity * values.part(material.kd), ks = opacity * values.part(material.ks);
    const Color kr = opacity * values.part(material.kr), kt = opacity * values.part(material.kt);
    const DielectricFresnel fresnel{eta};
    if (!is_black(kd)) lobes.add(LambertReflection{kd});
    if (!is_black(ks)) {
        lobes.add(MicrofacetReflection{ks, values.facets(material.roughness), fresnel});
    }
    if (!is_black(kr)) lobes.add(SpecularReflection{kr, fresnel});
    if (!is_black(kt)) lobes.add(SpecularTransmission{kt, eta});
}

}  // namespace etalon
