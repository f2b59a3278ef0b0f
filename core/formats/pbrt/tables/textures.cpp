// Textures of pbrt-v3 and their parameters: each class for numbers and for spectra.
#include <algorithm>

#include "core/formats/pbrt/tables/tables.h"

namespace etalon::pbrt {
namespace {

using namespace table;

constexpr Default all(ValueType type, float x) {
    return type == ValueType::color ? values(x, x, x) : value(x);
}

/// A value of the texture's own type.
constexpr ParameterSpec constant_of(ValueType type, std::string_view name, float x) {
    return {name, type, Slot::one, all(type, x)};
}

/// A texture of the same type, or a value.
constexpr ParameterSpec input_of(ValueType type, std::string_view name, float x) {
    return texture_slot(name, type, all(type, x));
}

constexpr std::array mapping_2d = {
    choice("mapping", "uv", "uv|spherical|cylindrical|planar"),
    number("uscale", 1),
    number("vscale", 1),
    number("udelta", 0),
    number("vdelta", 0),
    vector("v1", values(1, 0, 0)),
    vector("v2", values(0, 1, 0)),
};

template <std::size_t n>
constexpr auto mapped(const std::array<ParameterSpec, n>& own) {
    std::array<ParameterSpec, n + mapping_2d.size()> specs{};
    std::ranges::copy(mapping_2d, std::ranges::copy(own, specs.begin()).out);
    return specs;
}

/// The parameters of the classes that have textures or values of their own type.
template <ValueType type>
struct Of {
    static constexpr std::array constant = {constant_of(type, "value", 1)};
    static constexpr std::array scale = {input_of(type, "tex1", 1), input_of(type, "tex2", 1)};
    static constexpr std::array mix = {input_of(type, "tex1", 0), input_of(type, "tex2", 1),
                                       number_texture("amount", 0.5F)};
    static constexpr auto bilerp =
        mapped(std::array{constant_of(type, "v00", 0), constant_of(type, "v01", 1),
                          constant_of(type, "v10", 0), constant_of(type, "v11", 1)});
    static constexpr auto checkerboard = mapped(
        std::array{integer("dimension", 2), input_of(type, "tex1", 1), input_of(type, "tex2", 0),
                   choice("aamode", "closedform", "closedform|none")});
    static constexpr auto dots =
        mapped(std::array{input_of(type, "inside", 1), input_of(type, "outside", 0)});
};

// Where "gamma" is not given it is true for .png and .tga.
constexpr auto image_map = mapped(std::array{
    file("filename"), choice("wrap", "repeat", "repeat|black|clamp"), flag("trilinear", false),
    number("maxanisotropy", 8), number("scale", 1), optional_flag("gamma")});
constexpr std::array fbm = {integer("octaves", 8), number("roughness", 0.5F)};
constexpr std::array marble = {integer("octaves", 8), number("roughness", 0.5F), number("scale", 1),
                               number("variation", 0.2F)};
constexpr std::array ptex = {file("filename"), number("gamma", 2.2F)};

template <Category category, ValueType type>
constexpr std::array shared_types = {
    PluginType{category, "constant", Of<type>::constant},
    PluginType{category, "scale", Of<type>::scale},
    PluginType{category, "mix", Of<type>::mix},
    PluginType{category, "bilerp", Of<type>::bilerp},
    PluginType{category, "imagemap", image_map},
    PluginType{category, "checkerboard", Of<type>::checkerboard},
    PluginType{category, "dots", Of<type>::dots},
    PluginType{category, "fbm", fbm},
    PluginType{category, "wrinkled", fbm},
    PluginType{category, "windy", {}},
    PluginType{category, "ptex", ptex, {}, "the constant 1"},
};

constexpr auto float_types = shared_types<Category::float_texture, ValueType::number>;

/// "uv" and "marble" have no float texture in pbrt-v3.
constexpr auto spectrum_types = [] {
    constexpr auto& shared = shared_types<Category::spectrum_texture, ValueType::color>;
    std::array<PluginType, shared.size() + 2> all_types{};
    auto end = std::ranges::copy(shared, all_types.begin()).out;
    *end++ = {Category::spectrum_texture, "uv", mapping_2d};
    *end = {Category::spectrum_texture, "marble", marble};
    return all_types;
}();

}  // namespace

std::span<const PluginType> float_texture_types() {
    return float_types;
}

std::span<const PluginType> spectrum_texture_types() {
    return spectrum_types;
}

}  // namespace etalon::pbrt
