#include "core/texture/texture_values.h"

namespace etalon {
namespace {

/// The value of a constant texture, 1 for any other.
template <class T>
T constant(const Texture<T>& texture) {
    const auto* value = std::get_if<ConstantTexture<T>>(&texture);
    return value ? value->value : T(1.0F);
}

}  // namespace

TextureValues::TextureValues(const Textures& textures, std::vector<std::string>&)
    : textures_(textures) {}

float TextureValues::texture_number(std::uint32_t texture, const TexturePoint&) const {
    return constant(textures_.numbers[texture]);
}

Color TextureValues::texture_color(std::uint32_t texture, const TexturePoint&) const {
    return constant(textures_.colors[texture]);
}

}  // namespace etalon
