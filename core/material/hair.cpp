#include "core/material/add_lobes.h"

namespace etalon {
namespace {

Color absorption(const HairMaterial& material, const PointValues& values, float across_width) {
    switch (material.pigment) {
        case HairPigment::absorption:
            return values.part(material.color);
        case HairPigment::reflectance:
            return hair_absorption_of(values.part(material.color), across_width);
        case HairPigment::melanin:
            break;
    }
    return hair_absorption(std::max(0.0F, values.number(material.eumelanin)),
                           std::max(0.0F, values.number(material.pheomelanin)));
}

}  // namespace

void add_lobes(const HairMaterial& material, const PointValues& values, LobeList& lobes) {
    HairFibre fibre;
    fibre.h = static_cast<float>(2 * values.v() - 1);
    fibre.eta = values.number(material.eta);
    fibre.along_width = values.number(material.beta_m);
    fibre.across_width = values.number(material.beta_n);
    fibre.tilt = values.number(material.alpha);
    fibre.absorption = absorption(material, values, fibre.across_width);
    lobes.add(HairScattering(fibre));
}

}  // namespace etalon
