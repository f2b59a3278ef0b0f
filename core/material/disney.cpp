#include "core/material/add_lobes.h"
#include "core/material/subsurface.h"
#include "core/numerics/luminance.h"

namespace etalon {
namespace {

/// Values at a point that several lobes need.
struct DisneyPoint {
    const DisneyMaterial& material;
    const PointValues& values;
    Color color = values.part(material.color);
    float metallic = values.number(material.metallic);
    float eta = values.number(material.eta);
    float transmission = values.number(material.specular_transmission);
    float diffuse = (1 - metallic) * (1 - transmission);
    float transmitted = values.number(material.diffuse_transmission) / 2;  ///< diffuse fraction
    float roughness = values.number(material.roughness);
    /// Mean distance of light below the surface, which replaces diffuse reflection if it is not 0.
    Color scatter_distance =
        material.thin || !(diffuse > 0) ? Color(0) : values.part(material.scatter_distance);

    /// Interpolates from white to the colour's hue.
    Color tint(const NumberSlot& part) const {
        const float y = luminance(color), p = values.number(part);
        return Color(1 - p) + p * (y > 0 ? color / y : Color(1));
    }

    /// Returns the facets, elongated along u by the anisotropy.
    TrowbridgeReitz facets(float of_roughness) const {
        const float aspect = std::sqrt(1 - values.number(material.anisotropic) * 0.9F);
        const float alpha = of_roughness * of_roughness;
        return {alpha / aspect, alpha * aspect};
    }
};

void add_base(const DisneyPoint& at, LobeList& lobes) {
    const float flat = at.material.thin ? at.values.number(at.material.flatness) : 0;
    const float reflected = at.material.thin ? 1 - at.transmitted : 1;
    const float sheen = at.values.number(at.material.sheen);
    const float diffuse = is_black(at.scatter_distance) ? (1 - flat) * reflected : 0;
    DisneyBase base{at.diffuse * at.color, at.roughness, diffuse, flat * reflected, 1, Color(0)};
    if (sheen > 0) base.sheen = at.diffuse * sheen * at.tint(at.material.sheen_tint);
    if (!is_black(base.color) || !is_black(base.sheen)) lobes.add(base);
}

void add_gloss(const DisneyPoint& at, LobeList& lobes) {
    const float root = (at.eta - 1) / (at.eta + 1);
    const Color dielectric = root * root * at.tint(at.material.specular_tint);
    const Color from_above = (1 - at.metallic) * dielectric + at.metallic * at.color;
    lobes.add(DisneyGloss{Color(1), at.facets(at.roughness), {from_above, at.metallic, at.eta}});
    const float coat = at.values.number(at.material.clearcoat);
    if (coat > 0) {
        lobes.add(DisneyClearcoat(coat, at.values.number(at.material.clearcoat_gloss)));
    }
}

void add_transmission(const DisneyPoint& at, LobeList& lobes) {
    if (!is_black(at.scatter_distance)) lobes.add(SpecularTransmission{Color(1), at.eta});
    if (at.transmission > 0) {
        // Light that passes twice has the colour.
        const Color& c = at.color;
        const Color part = at.transmission * Color(std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z));
        if (passes_straight(at.eta)) {
            lobes.add(SpecularTransmission{part, 1});
        } else if (at.material.thin) {
            // Burley 2015, figure 15.
            const float scaled = (0.65F * at.eta - 0.35F) * at.roughness;
            lobes.add(MicrofacetTransmission{part, at.facets(scaled), at.eta});
        } else {
            lobes.add(DisneyTransmission{part, at.facets(at.roughness), at.eta});
        }
    }
    if (at.material.thin && at.transmitted > 0) {
        lobes.add(LambertTransmission{at.transmitted * at.color});
    }
}

}  // namespace

void add_lobes(const DisneyMaterial& material, const PointValues& values, LobeList& lobes) {
    const DisneyPoint at{material, values};
    if (at.diffuse > 0) add_base(at, lobes);
    add_gloss(at, lobes);
    add_transmission(at, lobes);
}

std::optional<Subsurface> subsurface_of(const DisneyMaterial& material, const PointValues& values) {
    const DisneyPoint at{material, values};
    if (is_black(at.scatter_distance)) return std::nullopt;
    return Subsurface{NormalizedProfile(at.diffuse * at.color, material.unit * at.scatter_distance),
                      at.eta};
}

}  // namespace etalon
