#include <array>

#include "tests/inventory/row.h"

namespace etalon::test {
namespace {

constexpr std::string_view rough = "\"float roughness\" 0.3";
constexpr std::string_view rough_both = "\"float uroughness\" 0.3 \"float vroughness\" 0.3";
constexpr std::string_view reflecting = "\"rgb Kr\" [.4 .4 .4]";
constexpr std::string_view shiny = "\"float metallic\" 1 \"float roughness\" 0.4";
constexpr std::string_view coated = "\"float clearcoat\" 1";
constexpr std::string_view fuzzy = "\"float sheen\" 1 \"rgb color\" [.2 .5 .9]";
constexpr std::string_view thin = "\"bool thin\" \"true\"";
constexpr std::string_view clear = "\"float spectrans\" 0.7 \"float roughness\" 0.3";
constexpr std::string_view skin = "\"rgb sigma_a\" [1 2 3] \"rgb sigma_s\" [9 8 7]";
constexpr std::string_view mixed =
    "\"string namedmaterial1\" \"red\" \"string namedmaterial2\" \"green\"";

constexpr std::array materials = {
    Row{"*", "bumpmap", "@waves"},
    Row{"*", "Kd", "0.8 0.3 0.1"},
    Row{"*", "Ks", "0.8 0.3 0.1"},
    Row{"*", "Kr", "0.8 0.3 0.1"},
    Row{"*", "Kt", "0.8 0.3 0.1"},
    Row{"*", "roughness", "0.4"},
    Row{"*", "uroughness", "0.4"},
    Row{"*", "vroughness", "0.4"},
    Row{"*", "remaproughness", "false", rough},
    Row{"matte", "sigma", "40"},
    Row{"translucent", "reflect", "0.9 0.4 0.1"},
    Row{"translucent", "transmit", "0.9 0.4 0.1"},
    Row{"glass", "eta", "1.9"},
    Row{"glass", "uroughness", "0.4"},
    Row{"glass", "vroughness", "0.4"},
    Row{"glass", "remaproughness", "false", rough_both},
    Row{"metal", "eta", "1.5 1.2 0.3"},
    Row{"metal", "k", "7 6 5"},
    Row{"substrate", "remaproughness", "false", rough_both},
    Row{"uber", "eta", "1.9", reflecting},
    Row{"uber", "opacity", "0.4 0.5 0.6"},
    Row{"disney", "color", "0.8 0.3 0.1"},
    Row{"disney", "metallic", "0.8"},
    Row{"disney", "eta", "1.9"},
    Row{"disney", "roughness", "0.2"},
    Row{"disney", "speculartint", "1", "\"rgb color\" [.8 .3 .1] \"float metallic\" 0.3"},
    Row{"disney", "anisotropic", "0.9", shiny},
    Row{"disney", "sheen", "1"},
    Row{"disney", "sheentint", "1", fuzzy},
    Row{"disney", "clearcoat", "1"},
    Row{"disney", "clearcoatgloss", "0.2", coated},
    Row{"disney", "spectrans", "0.7"},
    Row{"disney", "scatterdistance", "0.3 0.2 0.1"},
    Row{"disney", "thin", "true", clear},
    Row{"disney", "flatness", "0.8", thin},
    Row{"disney", "difftrans", "0.4", thin},
    Row{"hair", "sigma_a", "0.3 0.6 2"},
    Row{"hair", "color", "0.7 0.5 0.2"},
    Row{"hair", "eumelanin", "0.2"},
    Row{"hair", "pheomelanin", "0.8"},
    Row{"hair", "eta", "1.7"},
    Row{"hair", "beta_m", "0.6"},
    Row{"hair", "beta_n", "0.6"},
    Row{"hair", "alpha", "5"},
    Row{"subsurface", "name", "Skin1"},
    Row{"subsurface", "sigma_a", "1 2 3"},
    Row{"subsurface", "sigma_s", "9 3 2"},
    Row{"*", "g", "0.6", skin},
    Row{"*", "scale", "5"},
    Row{"*", "eta", "1.6"},
    Row{"subsurface", "remaproughness", "false", rough_both},
    Row{"kdsubsurface", "remaproughness", "false", rough_both},
    Row{"kdsubsurface", "g", "0.6"},
    Row{"kdsubsurface", "mfp", "0.2 0.1 0.05"},
    Row{"fourier", "bsdffile", "b.bsdf", {}, "a.bsdf"},
    Row{"fourier", "bumpmap", "@waves", "\"string bsdffile\" \"a.bsdf\""},
    Row{"mix", "namedmaterial1", "blue", mixed, "red"},
    Row{"mix", "namedmaterial2", "blue", mixed, "green"},
    Row{"mix", "amount", "0.9 0.2 0.5", mixed},
};

constexpr std::string_view cells =
    "\"integer nx\" 2 \"integer ny\" 2 \"integer nz\" 2 \"float density\" [0 1 2 3 4 3 2 1] "
    "\"point p0\" [-1 -1 -1] \"point p1\" [1 1 1] \"float scale\" 0.4";

constexpr std::array media = {
    Row{"heterogeneous", "nx", "4 ] \"integer ny\" [ 1", cells},
    Row{"heterogeneous", "ny", "4 ] \"integer nz\" [ 1", cells},
    Row{"heterogeneous", "nz", "4 ] \"integer nx\" [ 1", cells},
    Row{"heterogeneous", "p0", "-1 -0.2 -1", cells},
    Row{"heterogeneous", "p1", "0.5 1 1", cells},
    Row{"heterogeneous", "density", "3 1 2 0 1 3 2 1", cells, "0 1 2 3 4 3 2 1"},
    Row{"heterogeneous", "sigma_a", "1 2 3", cells},
    Row{"heterogeneous", "sigma_s", "1 2 3", cells},
    Row{"heterogeneous", "preset", "Ketchup", cells},
    Row{"heterogeneous", "g", "0.7", cells},
    Row{"heterogeneous", "scale", "2", cells},
    Row{"homogeneous", "sigma_a", "1 2 3"},
    Row{"homogeneous", "sigma_s", "1 2 3"},
    Row{"homogeneous", "preset", "Ketchup"},
    Row{"homogeneous", "g", "0.7"},
    Row{"homogeneous", "scale", "0.3"},
};

}  // namespace

std::span<const Row> material_rows() {
    return materials;
}
std::span<const Row> medium_rows() {
    return media;
}

}  // namespace etalon::test
