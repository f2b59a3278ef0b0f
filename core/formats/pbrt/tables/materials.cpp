// Materials of pbrt-v3 and their parameters.
#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr ParameterSpec bump_map = number_texture("bumpmap");
constexpr ParameterSpec remap = flag("remaproughness", true);
constexpr ParameterSpec smooth_u = number_texture("uroughness", 0);
constexpr ParameterSpec smooth_v = number_texture("vroughness", 0);
// Where these are not given, "roughness" stands for both.
constexpr ParameterSpec optional_u = number_texture("uroughness");
constexpr ParameterSpec optional_v = number_texture("vroughness");
constexpr ParameterSpec eta_or_index = also(number_texture("eta", 1.5F), "index");
constexpr ParameterSpec reflected = color_texture("Kr", 1), transmitted = color_texture("Kt", 1);
constexpr ParameterSpec roughness = number_texture("roughness", 0.1F);

constexpr std::array matte = {color_texture("Kd", 0.5F), number_texture("sigma", 0), bump_map};
constexpr std::array plastic = {color_texture("Kd", 0.25F), color_texture("Ks", 0.25F), roughness,
                                remap, bump_map};
constexpr std::array translucent = {color_texture("Kd", 0.25F),
                                    color_texture("Ks", 0.25F),
                                    color_texture("reflect", 0.5F),
                                    color_texture("transmit", 0.5F),
                                    roughness,
                                    remap,
                                    bump_map};
constexpr std::array glass = {reflected, transmitted, eta_or_index, smooth_u,
                              smooth_v,  remap,       bump_map};
constexpr std::array mirror = {color_texture("Kr", 0.9F), bump_map};
// The defaults are copper, as pbrt-v3 sums its spectra.
constexpr std::array metal = {
    color_texture("eta", values(0.19999F, 0.92209F, 1.09988F)),
    color_texture("k", values(3.90464F, 2.44763F, 2.13765F)),
    number_texture("roughness", 0.01F),
    optional_u,
    optional_v,
    remap,
    bump_map,
};
constexpr std::array substrate = {color_texture("Kd", 0.5F),
                                  color_texture("Ks", 0.5F),
                                  number_texture("uroughness", 0.1F),
                                  number_texture("vroughness", 0.1F),
                                  remap,
                                  bump_map};
constexpr std::array uber = {color_texture("Kd", 0.25F),
                             color_texture("Ks", 0.25F),
                             color_texture("Kr", 0),
                             color_texture("Kt", 0),
                             roughness,
                             optional_u,
                             optional_v,
                             eta_or_index,
                             color_texture("opacity", 1),
                             remap,
                             bump_map};
constexpr std::array disney = {
    color_texture("color", 0.5F),
    number_texture("metallic", 0),
    number_texture("eta", 1.5F),
    number_texture("roughness", 0.5F),
    number_texture("speculartint", 0),
    number_texture("anisotropic", 0),
    number_texture("sheen", 0),
    number_texture("sheentint", 0.5F),
    number_texture("clearcoat", 0),
    number_texture("clearcoatgloss", 1),
    number_texture("spectrans", 0),
    color_texture("scatterdistance", 0),
    flag("thin", false),
    number_texture("flatness", 0),
    number_texture("difftrans", 1),
    bump_map,
};
// sigma_a, color and the two concentrations take precedence in this order; without any of them the
// concentration of eumelanin is 1.3.
constexpr std::array hair = {
    color_texture("sigma_a"),       color_texture("color"),       number_texture("eumelanin"),
    number_texture("pheomelanin"),  number_texture("eta", 1.55F), number_texture("beta_m", 0.3F),
    number_texture("beta_n", 0.3F), number_texture("alpha", 2),
};
constexpr std::array subsurface = {
    string("name"),
    color_texture("sigma_a", values(0.0011F, 0.0024F, 0.014F)),
    color_texture("sigma_s", values(2.55F, 3.21F, 3.77F)),
    number("g", 0),
    number("scale", 1),
    number("eta", 1.33F),
    reflected,
    transmitted,
    smooth_u,
    smooth_v,
    remap,
    bump_map,
};
constexpr std::array kd_subsurface = {
    color_texture("Kd", 0.5F),
    color_texture("mfp", 1),
    number("eta", 1.33F),
    number("g", 0),
    number("scale", 1),
    reflected,
    transmitted,
    smooth_u,
    smooth_v,
    remap,
    bump_map,
};
constexpr std::array fourier = {file("bsdffile"), bump_map};
constexpr ParameterSpec material_name(std::string_view name) {
    return {name, ValueType::material, Slot::one};
}
constexpr std::array mix = {material_name("namedmaterial1"), material_name("namedmaterial2"),
                            color_texture("amount", 0.5F)};

constexpr std::array types = {
    PluginType{Category::material, "matte", matte},
    PluginType{Category::material, "plastic", plastic},
    PluginType{Category::material, "translucent", translucent},
    PluginType{Category::material, "glass", glass},
    PluginType{Category::material, "mirror", mirror},
    PluginType{Category::material, "metal", metal},
    PluginType{Category::material, "substrate", substrate},
    PluginType{Category::material, "uber", uber},
    PluginType{Category::material, "disney", disney},
    PluginType{Category::material, "hair", hair},
    PluginType{Category::material, "subsurface", subsurface},
    PluginType{Category::material, "kdsubsurface", kd_subsurface},
    PluginType{Category::material, "fourier", fourier},
    PluginType{Category::material, "mix", mix},
    // The name is empty where a surface only bounds a medium.
    PluginType{Category::material, "none", {}},
};

}  // namespace

std::span<const PluginType> material_types() {
    return types;
}

}  // namespace etalon::pbrt
