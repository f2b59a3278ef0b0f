#include "core/material/add_lobes.h"

namespace etalon {

void add_lobes(const UberMaterial& material, const PointValues& values, Bsdf& bsdf) {
    const float eta = values.number(material.eta);
    const Color opacity = values.part(material.opacity);
    const auto missing = [](float part) { return std::max(0.0F, 1 - part); };
    const Color clear(missing(opacity.x), missing(opacity.y), missing(opacity.z));
    if (!is_black(clear)) bsdf.add(SpecularTransmission{clear, 1});

    const Color kd = opacity * values.part(material.kd), ks = opacity * values.part(material.ks);
    const Color kr = opacity * values.part(material.kr), kt = opacity * values.part(material.kt);
    const DielectricFresnel fresnel{eta};
    if (!is_black(kd)) bsdf.add(LambertReflection{kd});
    if (!is_black(ks)) {
        bsdf.add(MicrofacetReflection{ks, values.facets(material.roughness), fresnel});
    }
    if (!is_black(kr)) bsdf.add(SpecularReflection{kr, fresnel});
    if (!is_black(kt)) bsdf.add(SpecularTransmission{kt, eta});
}

}  // namespace etalon
