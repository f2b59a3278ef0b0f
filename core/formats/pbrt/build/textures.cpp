// Textures of a frame, each by one line of a table, for numbers and for colours.
#include <algorithm>
#include <array>

#include "core/formats/pbrt/build/scene_builder.h"

namespace etalon::pbrt {
namespace {

/// Functions that exist once for each type of value.
template <class T>
struct Values {
    static etalon::Slot<T> slot(SceneBuilder& b, const Parameters& p, std::string_view name) {
        if constexpr (std::is_same_v<T, float>) {
            return b.number(p, name);
        } else {
            return b.color(p, name);
        }
    }
    static T value(const Parameters& p, std::string_view name) {
        if constexpr (std::is_same_v<T, float>) {
            return p.number(name);
        } else {
            return p.color(name);
        }
    }
};

Affine to_texture(SceneBuilder& b, const pbrt::Texture& t) {
    const std::optional<Affine> map = b.affine(t.to_world, t.plugin.where);
    return map ? inverse(*map) : Affine{};
}

/// Returns the map from the world to a texture in space. As in pbrt-v3 this is the transformation
/// at the texture's directive, not its inverse as for the mappings of surfaces.
Affine to_texture_3d(SceneBuilder& b, const pbrt::Texture& t) {
    return b.affine(t.to_world, t.plugin.where).value_or(Affine{});
}

Mapping mapping(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    const std::string_view name = p.string("mapping");
    if (name == "spherical") return SphericalMapping{to_texture(b, t)};
    if (name == "cylindrical") return CylindricalMapping{to_texture(b, t)};
    if (name == "planar") {
        return PlanarMapping{Vec3(p.vector("v1")), Vec3(p.vector("v2")), p.number("udelta"),
                             p.number("vdelta")};
    }
    return UvMapping{p.number("uscale"), p.number("vscale"), p.number("udelta"),
                     p.number("vdelta")};
}

template <class T>
etalon::Texture<T> constant(SceneBuilder&, const pbrt::Texture& t) {
    return ConstantTexture<T>{Values<T>::value(t.plugin.parameters, "value")};
}

template <class T>
etalon::Texture<T> scale(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    return ScaleTexture<T>{Values<T>::slot(b, p, "tex1"), Values<T>::slot(b, p, "tex2")};
}

template <class T>
etalon::Texture<T> mix(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    return MixTexture<T>{Values<T>::slot(b, p, "tex1"), Values<T>::slot(b, p, "tex2"),
                         b.number(p, "amount")};
}

template <class T>
etalon::Texture<T> bilerp(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    return BilinearTexture<T>{mapping(b, t), Values<T>::value(p, "v00"), Values<T>::value(p, "v01"),
                              Values<T>::value(p, "v10"), Values<T>::value(p, "v11")};
}

template <class T>
etalon::Texture<T> checkerboard(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    const etalon::Slot<T> even = Values<T>::slot(b, p, "tex1"), odd = Values<T>::slot(b, p, "tex2");
    const int dimension = p.integer("dimension");
    if (dimension == 3) return Checkerboard3<T>{to_texture_3d(b, t), even, odd};
    if (dimension != 2) {
        b.warn(t.plugin.where, "range",
               "a checkerboard of dimension {}: expected 2 or 3; taken as 2", dimension);
    }
    return Checkerboard2<T>{mapping(b, t), even, odd};
}

/// pbrt-v3's "inside" is around the dots: it uses the two in the other order.
template <class T>
etalon::Texture<T> dots(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    return DotsTexture<T>{mapping(b, t), Values<T>::slot(b, p, "outside"),
                          Values<T>::slot(b, p, "inside")};
}

FractalNoise fractal_noise(const Parameters& p) {
    return {p.integer("octaves"), p.number("roughness")};
}

template <class T>
etalon::Texture<T> fbm(SceneBuilder& b, const pbrt::Texture& t) {
    return FbmTexture{to_texture_3d(b, t), fractal_noise(t.plugin.parameters)};
}

template <class T>
etalon::Texture<T> wrinkled(SceneBuilder& b, const pbrt::Texture& t) {
    return WrinkledTexture{to_texture_3d(b, t), fractal_noise(t.plugin.parameters)};
}

template <class T>
etalon::Texture<T> windy(SceneBuilder& b, const pbrt::Texture& t) {
    return WindyTexture{to_texture_3d(b, t)};
}

template <class T>
etalon::Texture<T> marble(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    return MarbleTexture{to_texture_3d(b, t), fractal_noise(p), p.number("scale"),
                         p.number("variation")};
}

template <class T>
etalon::Texture<T> uv(SceneBuilder& b, const pbrt::Texture& t) {
    return UvTexture{mapping(b, t)};
}

Wrap wrap(std::string_view name) {
    return name == "black" ? Wrap::black : name == "clamp" ? Wrap::clamp : Wrap::repeat;
}

bool ends_with_any_case(std::string_view text, std::string_view ending) {
    const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? c - 'A' + 'a' : c; };
    if (text.size() < ending.size()) return false;
    return std::ranges::equal(text.substr(text.size() - ending.size()), ending, {}, lower);
}

/// Returns whether a file's values are sRGB-encoded if the scene does not say.
bool is_display_format(const std::string& file) {
    return ends_with_any_case(file, ".png") || ends_with_any_case(file, ".tga");
}

/// Returns the number of an image. Textures of the same file and values share it.
std::uint32_t image_number(SceneBuilder& b, const TextureImage& image) {
    auto& images = b.look().textures.images;
    const auto next = static_cast<std::uint32_t>(images.size());
    const auto [place, is_new] =
        b.image_numbers.try_emplace({image.file, image.wrap, image.decode_srgb, image.scale}, next);
    if (is_new) images.push_back(image);
    return place->second;
}

template <class T>
etalon::Texture<T> image_map(SceneBuilder& b, const pbrt::Texture& t) {
    const Parameters& p = t.plugin.parameters;
    const std::string file(p.string("filename"));
    const bool decode = p.is_given("gamma") ? p.flag("gamma") : is_display_format(file);
    const std::uint32_t number =
        image_number(b, {file, wrap(p.string("wrap")), decode, p.number("scale")});
    b.name_image(file, t.plugin.where, "grey");
    return ImageTexture<T>{mapping(b, t), number};
}

template <class T>
struct Entry {
    std::string_view name;
    etalon::Texture<T> (*build)(SceneBuilder&, const pbrt::Texture&);
};

// To add a texture: a function above and a line here.
template <class T>
constexpr std::array entries = {
    Entry<T>{"constant", constant<T>},
    Entry<T>{"scale", scale<T>},
    Entry<T>{"mix", mix<T>},
    Entry<T>{"bilerp", bilerp<T>},
    Entry<T>{"imagemap", image_map<T>},
    Entry<T>{"checkerboard", checkerboard<T>},
    Entry<T>{"dots", dots<T>},
    Entry<T>{"fbm", fbm<T>},
    Entry<T>{"wrinkled", wrinkled<T>},
    Entry<T>{"windy", windy<T>},
    Entry<T>{"marble", marble<T>},
    Entry<T>{"uv", uv<T>},
};

template <class T>
etalon::Texture<T> build(SceneBuilder& b, const pbrt::Texture& t) {
    const auto* const entry = std::ranges::find(entries<T>, t.plugin.type->name, &Entry<T>::name);
    if (entry != entries<T>.end()) return entry->build(b, t);
    warn_of_stand_in(b, t.plugin);
    return ConstantTexture<T>{T(1.0F)};
}

/// Limit of the textures that are evaluated for one value. Deeper nests do not occur in scenes, and
/// could take years, or overflow the stack.
constexpr std::size_t most_evaluations = 1000;

/// Returns how many textures are evaluated for one value of `t`, if those it refers to take `of`.
std::size_t evaluations(const pbrt::Texture& t, const std::vector<std::size_t>& of) {
    std::size_t sum = 1;
    for (const Argument& a : t.plugin.parameters.arguments()) {
        if (const auto* input = std::get_if<TextureNumber>(&a.values)) sum += of[input->number];
    }
    return sum;
}

/// The same, but replaces a nest that is too large by a constant.
template <class T>
etalon::Texture<T> build_bounded(SceneBuilder& b, const pbrt::Texture& t, std::size_t& cost) {
    if (cost <= most_evaluations) return build<T>(b, t);
    b.warn(t.plugin.where, "nest",
           "more than {} textures are nested in this one; the constant 1 stands in for it",
           most_evaluations);
    cost = 1;
    return ConstantTexture<T>{T(1.0F)};
}

template <class T>
std::uint32_t append(std::vector<T>& list, T&& value) {
    list.push_back(std::forward<T>(value));
    return static_cast<std::uint32_t>(list.size() - 1);
}

}  // namespace

void build_textures(SceneBuilder& b) {
    Textures& textures = b.look().textures;
    std::vector<std::size_t> costs;
    for (const pbrt::Texture& t : b.frame.textures) {
        costs.push_back(evaluations(t, costs));
        const bool is_number = t.plugin.type->category == Category::float_texture;
        b.texture_numbers.push_back(
            is_number ? append(textures.numbers, build_bounded<float>(b, t, costs.back()))
                      : append(textures.colors, build_bounded<Color>(b, t, costs.back())));
    }
}

}  // namespace etalon::pbrt
