#include "core/convert/physical_material.h"

#include <algorithm>
#include <cmath>

namespace etalon {
namespace {

const Color black(0.0F), white(1.0F);

/// Index of the dielectric whose gloss replaces a highlight.
constexpr float gloss_index = 1.5F;

/// Mean reflectance of such a dielectric.
constexpr float gloss_albedo = 0.09F;

/// Remaining weights of a material's parts, as light.
struct Weights {
    Color diffuse, specular, reflection, transmission;
};

Color larger(const Color& a, const Color& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// Reduces weights until no more light leaves than arrives. Mirrored light is not transmitted.
Weights conserving(Weights w) {
    for (int k = 0; k < 3; ++k) {
        const float sum = w.diffuse[k] + gloss_albedo * w.specular[k] +
                          std::max(w.reflection[k], w.transmission[k]);
        if (!(sum > 1)) continue;
        for (Color* part : {&w.diffuse, &w.specular, &w.reflection, &w.transmission}) {
            (*part)[k] /= sum;
        }
    }
    return w;
}

/// Returns the alpha of microfacets whose highlight is as wide as that of Blinn's exponent (Walter
/// et al. 2007, "Microfacet Models for Refraction", section 5.2). A power of the cosine to the
/// reflected ray is about as wide as four times the exponent to the half vector (Fisher and Woo
/// 1994, "R.E versus N.H Specular Highlights").
Roughness roughness_of(const Material& m) {
    const double exponent = std::max(0.0, m.shininess) * (m.highlight == Highlight::phong ? 4 : 1);
    const auto alpha = static_cast<float>(std::clamp(std::sqrt(2 / (exponent + 2)), 0.001, 1.0));
    return {{alpha}, {alpha}, false};
}

PhysicalMaterial glass(const Material& m, const Weights& w) {
    const NumberSlot eta{m.ior > 0 ? static_cast<float>(m.ior) : 1.0F};
    if (w.diffuse == black && w.specular == black) {
        return {GlassMaterial{{w.reflection}, {w.transmission}, eta, {{0.0F}, {0.0F}, true}}};
    }
    return {UberMaterial{{w.diffuse},
                         {w.specular},
                         {w.reflection},
                         {w.transmission},
                         {white},
                         eta,
                         roughness_of(m)}};
}

/// Returns the part that is neither mirror nor glass, with its colours times `factor`.
PhysicalMaterial opaque(const Material& m, const Weights& w, float factor) {
    if (w.specular == black) return {MatteMaterial{{w.diffuse * factor}, {0.0F}}};
    return {UberMaterial{{w.diffuse * factor},
                         {w.specular * factor},
                         {black},
                         {black},
                         {white},
                         {gloss_index},
                         roughness_of(m)}};
}

std::uint32_t add(PhysicalMaterial material, std::vector<PhysicalMaterial>& to) {
    to.push_back(std::move(material));
    return static_cast<std::uint32_t>(to.size() - 1);
}

}  // namespace

std::uint32_t add_physical(const Material& m, const LightValues& light,
                           std::vector<PhysicalMaterial>& to) {
    Weights w{light(m.diffuse), light(m.specular), light(m.reflection), light(m.transmission)};
    // For glass with constant weights, Fresnel's equations divide the light instead.
    if (w.transmission != black && !m.fresnel) w.reflection = larger(w.reflection, w.transmission);
    w = conserving(w);
    if (w.transmission != black) return add(glass(m, w), to);
    if (w.reflection == black) return add(opaque(m, w, 1), to);
    if (w.diffuse == black && w.specular == black) return add({MirrorMaterial{{w.reflection}}}, to);
    // The mean of two materials, each with twice its weight, is their sum.
    const std::uint32_t first = add(opaque(m, w, 2), to);
    const std::uint32_t second = add({MirrorMaterial{{w.reflection * 2.0F}}}, to);
    return add({MixedMaterial{first, second, {Color(0.5F)}}}, to);
}

}  // namespace etalon
