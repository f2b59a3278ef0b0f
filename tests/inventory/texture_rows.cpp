// Float and spectrum textures have the same classes, except for two.
#include <array>

#include "tests/inventory/row.h"

namespace etalon::test {
namespace {

constexpr std::string_view map = "\"string filename\" \"a.png\" ";
constexpr std::string_view no_footprints = "textures are not filtered over footprints";
constexpr std::string_view no_ptex = "ptex is not supported";
constexpr std::string_view planar = "\"string mapping\" \"planar\" ";
constexpr std::string_view planar_map =
    "\"string mapping\" \"planar\" \"string filename\" \"a.png\" ";

constexpr std::string_view checks = "\"float uscale\" 4 \"float vscale\" 3 ";

/// `one` and `other` are values of the textures' type.
constexpr auto rows_with(std::string_view one, std::string_view other) {
    return std::array{
        Row{"imagemap", "filename", "b.png", {}, "a.png"},
        Row{"imagemap", "wrap", "black", "\"string filename\" \"a.png\" \"float uscale\" 3"},
        Row{"imagemap", "trilinear", "true", map, {}, no_footprints},
        Row{"imagemap", "maxanisotropy", "1", map, {}, no_footprints},
        Row{"imagemap", "scale", "0.4", map},
        Row{"imagemap", "gamma", "false", map},
        Row{"imagemap", "mapping", "planar", map},
        Row{"imagemap", "uscale", "3", map},
        Row{"imagemap", "vscale", "3", map},
        Row{"imagemap", "udelta", "0.3", map},
        Row{"imagemap", "vdelta", "0.3", map},
        Row{"imagemap", "v1", "0.3 0 0.7", planar_map},
        Row{"imagemap", "v2", "0.3 0 0.7", planar_map},
        Row{"ptex", "filename", "a.ptx", {}, "b.ptx", no_ptex},
        Row{"ptex", "gamma", "1", {}, {}, no_ptex},
        Row{"checkerboard", "dimension", "3"},
        Row{"checkerboard", "tex2", other, checks},
        Row{"checkerboard", "mapping", "spherical", checks},
        Row{"checkerboard", "aamode", "none", {}, {}, no_footprints},
        Row{"*", "mapping", "spherical"},
        Row{"*", "uscale", "3"},
        Row{"*", "vscale", "3"},
        Row{"*", "udelta", "0.7"},
        Row{"*", "vdelta", "0.7"},
        Row{"*", "v1", "0.3 0 2.7", planar},
        Row{"*", "v2", "0.3 0 2.7", planar},
        Row{"*", "value", one},
        Row{"*", "tex1", one},
        Row{"*", "tex2", other},
        Row{"scale", "tex2", one},
        Row{"mix", "amount", "0.9"},
        Row{"*", "v00", one},
        Row{"*", "v01", other},
        Row{"*", "v10", one},
        Row{"*", "v11", other},
        Row{"*", "inside", one},
        Row{"*", "outside", other},
        Row{"*", "octaves", "2"},
        Row{"*", "roughness", "0.9"},
        Row{"marble", "scale", "3"},
        Row{"marble", "variation", "5"},
    };
}

constexpr auto number_rows = rows_with("0.3", "0.6");
constexpr auto color_rows = rows_with("0.9 0.4 0.1", "0.2 0.3 0.6");

}  // namespace

std::span<const Row> float_texture_rows() {
    return number_rows;
}
std::span<const Row> spectrum_texture_rows() {
    return color_rows;
}

}  // namespace etalon::test
