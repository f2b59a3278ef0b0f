#include "core/formats/write/pbrt_material.h"

#include <algorithm>
#include <cmath>

#include "core/formats/write/text.h"

namespace etalon {
namespace {

const Color black(0.0F), white(1.0F);

std::string named(std::string_view name, std::string_view type, std::string_view parameters) {
    return fmt::format("MakeNamedMaterial \"{}\" \"string type\" \"{}\" {}", name, type,
                       parameters);
}

/// Roughness whose lobes are as wide as Phong's of this exponent, by Walter et al. 2007,
/// "Microfacet Models for Refraction".
double roughness_of(double exponent) {
    return std::clamp(std::sqrt(2 / (exponent + 2)), 0.001, 1.0);
}

std::string glass(const Material& m, std::string_view name, ConversionWarnings& lost) {
    if (!m.fresnel) lost.add("constant weights of mirrored and refracted rays, now Fresnel's");
    if (m.diffuse != black || m.specular != black)
        lost.add("diffuse colour and highlight of glass");
    if (m.absorption != black) lost.add("absorption");
    const Color reflection = m.fresnel ? m.reflection : white;
    return named(name, "glass",
                 fmt::format("\"rgb Kr\" [ {} ] \"rgb Kt\" [ {} ] \"float eta\" [ {} ]", reflection,
                             m.transmission, m.ior));
}

/// Returns the part of a material that is not mirroring, with its colours times `weight`.
std::string matt_part(const Material& m, std::string_view name, float weight,
                      ConversionWarnings& lost) {
    const Color diffuse = m.diffuse * weight, specular = m.specular * weight;
    if (specular == black) {
        return named(name, "matte", fmt::format("\"rgb Kd\" [ {} ]", diffuse));
    }
    lost.add("highlight, now a plastic's");
    return named(name, "plastic",
                 fmt::format("\"rgb Kd\" [ {} ] \"rgb Ks\" [ {} ] \"float roughness\" [ {} ] "
                             "\"bool remaproughness\" \"false\"",
                             diffuse, specular, roughness_of(m.shininess)));
}

std::string mirror(std::string_view name, const Color& reflection) {
    return named(name, "mirror", fmt::format("\"rgb Kr\" [ {} ]", reflection));
}

}  // namespace

std::string to_pbrt(const Material& m, std::string_view name, ConversionWarnings& lost) {
    if (m.ambient != black) lost.add("ambient colour of a material");
    if (m.transmission != black) return glass(m, name, lost);
    if (m.reflection == black) return matt_part(m, name, 1, lost);
    if (m.diffuse == black && m.specular == black) return mirror(name, m.reflection);
    // The mean of two materials, each of twice its weight, is their sum.
    const std::string matt = fmt::format("{}-matt", name), bright = fmt::format("{}-mirror", name);
    return matt_part(m, matt, 2, lost) + "\n" + mirror(bright, m.reflection * 2.0F) + "\n" +
           named(name, "mix",
                 fmt::format("\"string namedmaterial1\" \"{}\" \"string namedmaterial2\" \"{}\" "
                             "\"rgb amount\" [ 0.5 0.5 0.5 ]",
                             matt, bright));
}

}  // namespace etalon
