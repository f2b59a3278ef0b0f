// Materials that transmit no light.
#include "core/material/add_lobes.h"

namespace etalon {

void add_lobes(const MatteMaterial& material, const PointValues& values, LobeList& lobes) {
    const Color kd = values.part(material.kd);
    if (is_black(kd)) return;
    const float sigma = std::clamp(values.number(material.sigma), 0.0F, 90.0F);
    if (sigma == 0) {
        lobes.add(LambertReflection{kd});
    } else {
        lobes.add(OrenNayarReflection(kd, sigma));
    }
}

void add_lobes(const PlasticMaterial& material, const PointValues& values, LobeList& lobes) {
    // PBRT version 3 has the index above the surface and not below it: gloss is total from 42
    // degrees on, as its images show.
    constexpr float eta = 1 / 1.5F;
    const Color kd = values.part(material.kd), ks = values.part(material.ks);
    if (!is_black(kd)) lobes.add(LambertReflection{kd});
    if (is_black(ks)) return;
    lobes.add(MicrofacetReflection{ks, values.facets(material.roughness), DielectricFresnel{eta}});
}

void add_lobes(const MirrorMaterial& material, const PointValues& values, LobeList& lobes) {
    const Color kr = values.part(material.kr);
    if (!is_black(kr)) lobes.add(SpecularReflection{kr, NoFresnel{}});
}

void add_lobes(const MetalMaterial& material, const PointValues& values, LobeList& lobes) {
    const ConductorFresnel fresnel{values.color(material.eta), values.color(material.k)};
    lobes.add(MicrofacetReflection{Color(1), values.facets(material.roughness), fresnel});
}

void add_lobes(const SubstrateMaterial& material, const PointValues& values, LobeList& lobes) {
    const Color kd = values.part(material.kd), ks = values.part(material.ks);
    if (is_black(kd) && is_black(ks)) return;
    lobes.add(FresnelBlend{kd, ks, values.facets(material.roughness)});
}

}  // namespace etalon
