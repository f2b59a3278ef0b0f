// Materials with a dielectric interface to the air and nothing below it.
#include "core/material/add_lobes.h"

namespace etalon {

void add_lobes(const GlassMaterial& material, const PointValues& values, LobeList& lobes) {
    const Color kr = values.part(material.kr), kt = values.part(material.kt);
    if (is_black(kr) && is_black(kt)) return;
    const float eta = values.number(material.eta);
    const Roughness& roughness = material.roughness;
    if (values.number(roughness.u) == 0 && values.number(roughness.v) == 0) {
        lobes.add(FresnelSpecular{kr, kt, eta});
        return;
    }
    const TrowbridgeReitz facets = values.facets(roughness);
    if (!is_black(kr)) lobes.add(MicrofacetReflection{kr, facets, DielectricFresnel{eta}});
    if (is_black(kt)) return;
    if (passes_straight(eta)) return lobes.add(SpecularTransmission{kt, 1});
    lobes.add(MicrofacetTransmission{kt, facets, eta});
}

void add_lobes(const TranslucentMaterial& material, const PointValues& values, LobeList& lobes) {
    constexpr float eta = 1.5F;
    const Color r = values.part(material.reflect), t = values.part(material.transmit);
    const Color kd = values.part(material.kd), ks = values.part(material.ks);
    if (!is_black(r * kd)) lobes.add(LambertReflection{r * kd});
    if (!is_black(t * kd)) lobes.add(LambertTransmission{t * kd});
    if (is_black(r * ks) && is_black(t * ks)) return;
    const TrowbridgeReitz facets = values.facets(material.roughness);
    if (!is_black(r * ks)) lobes.add(MicrofacetReflection{r * ks, facets, DielectricFresnel{eta}});
    if (!is_black(t * ks)) lobes.add(MicrofacetTransmission{t * ks, facets, eta});
}

}  // namespace etalon
