#include "core/texture/texels.h"

#include "core/texture/near_texels.h"

namespace etalon {

Texels::Texels(const SharedTexels& texels, const TextureImage& how)
    : byte_values_(how.decode_srgb ? &decoded_byte_values() : &detail::byte_values),
      wrap_(how.wrap),
      scale_(how.scale) {
    if (const auto* image = std::get_if<std::shared_ptr<const Image>>(&texels)) image_ = *image;
    if (const auto* image = std::get_if<std::shared_ptr<const PackedImage>>(&texels)) {
        packed_ = *image;
    }
}

template <class Stored>
float Texels::shown(Stored value) const {
    if constexpr (sizeof(value) == 1) {
        return (*byte_values_)[value];
    } else {
        return value;
    }
}

template <class Value>
Value Texels::interpolated(const Vec2& st) const {
    const NearTexels near = near_texels(image_->width, image_->height, wrap_, st);
    const auto texel = [&](const auto* p) {
        if constexpr (std::is_same_v<Value, float>) {
            return shown(p[0]);
        } else {
            return image_->channels < 3 ? Color(shown(p[0]))
                                        : Color(shown(p[0]), shown(p[1]), shown(p[2]));
        }
    };
    return std::visit(
        [&](const auto& values) {
            Value sum(0.0F);
            for (std::size_t k = 0; k < 4; ++k) {
                if (near.weights[k] == 0) continue;  // the texel may be infinite
                sum += texel(&values[near.texels[k] * image_->channels]) * near.weights[k];
            }
            return sum * scale_;
        },
        image_->pixels);
}

Color Texels::interpolated_packed(const Vec2& st) const {
    const NearTexels near = near_texels(packed_->width, packed_->height, wrap_, st);
    Color sum(0.0F);
    for (std::size_t k = 0; k < 4; ++k) {
        sum += unpacked(packed_->texels[near.texels[k]]) * near.weights[k];
    }
    return sum * scale_;
}

Color Texels::color(const Vec2& st) const {
    return packed_ ? interpolated_packed(st) : interpolated<Color>(st);
}

float Texels::number(const Vec2& st) const {
    return interpolated<float>(st);
}

std::optional<ZeroTexels> Texels::zeros() const {
    // Weights are 2^-108 or more where they are not 0, and sums are of numbers of one sign.
    const auto is_usual = [](float value) { return value == 0 || (value > 1e-5F && value < 1e5F); };
    if (!is_usual(scale_)) return std::nullopt;
    return std::visit(
        [&](const auto& values) -> std::optional<ZeroTexels> {
            ZeroTexels zeros(image_->width, image_->height, wrap_);
            const std::size_t count = values.size() / image_->channels;
            for (std::size_t i = 0; i < count; ++i) {
                const float value = shown(values[i * image_->channels]) * scale_;
                if (!is_usual(value)) return std::nullopt;
                if (value != 0) zeros.set_not_zero(i);
            }
            return zeros;
        },
        image_->pixels);
}

}  // namespace etalon
