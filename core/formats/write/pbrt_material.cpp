#include "core/formats/write/pbrt_material.h"

#include "core/formats/write/text.h"

namespace etalon {
namespace {

const Color black(0.0F);

/// Writes the type and the parameters of a material without textures.
struct MaterialText {
    std::string operator()(const MatteMaterial& m) const {
        return fmt::format("\"matte\" \"rgb Kd\" [ {} ]", m.kd.value);
    }
    std::string operator()(const MirrorMaterial& m) const {
        return fmt::format("\"mirror\" \"rgb Kr\" [ {} ]", m.kr.value);
    }
    std::string operator()(const GlassMaterial& m) const {
        return fmt::format("\"glass\" \"rgb Kr\" [ {} ] \"rgb Kt\" [ {} ] \"float eta\" [ {} ]",
                           m.kr.value, m.kt.value, m.eta.value);
    }
    std::string operator()(const UberMaterial& m) const {
        return fmt::format(
            "\"uber\" \"rgb Kd\" [ {} ] \"rgb Ks\" [ {} ] \"rgb Kr\" [ {} ] \"rgb Kt\" [ {} ] "
            "\"float eta\" [ {} ] \"float roughness\" [ {} ] \"bool remaproughness\" \"false\"",
            m.kd.value, m.ks.value, m.kr.value, m.kt.value, m.eta.value, m.roughness.u.value);
    }
    std::string operator()(const MixedMaterial& m) const {
        return fmt::format(
            "\"mix\" \"string namedmaterial1\" \"m{}\" \"string namedmaterial2\" \"m{}\" "
            "\"rgb amount\" [ {} ]",
            m.first, m.second, m.amount.value);
    }
    /// The conversion makes no others.
    template <class Other>
    std::string operator()(const Other&) const {
        return "\"none\"";
    }
};

}  // namespace

void warn_of_losses(const Material& m, ConversionWarnings& lost) {
    if (m.ambient != black) lost.add("ambient colour of a material");
    if (m.transmission == black) {
        if (m.specular != black) lost.add("highlight, now a rough gloss");
        return;
    }
    if (!m.fresnel) lost.add("constant weights of reflected and refracted rays, now Fresnel's");
    if (m.absorption != black) lost.add("absorption");
}

std::string to_pbrt(const std::vector<PhysicalMaterial>& materials, std::uint32_t number) {
    return fmt::format("MakeNamedMaterial \"m{}\" \"string type\" {}", number,
                       std::visit(MaterialText(), materials[number].kind));
}

}  // namespace etalon
