#include "core/texture/texels.h"

#include <algorithm>
#include <cmath>

namespace etalon {
namespace {

/// Two texels of a row or column, of weights 1 - fraction and fraction; -1 is one that is black.
struct Pair {
    int first, second;
    float fraction;
};

/// A coordinate within the range where indices fit an int: one period of an image that repeats, or
/// so much more than the image that its border, or black, is met as farther away.
double in_range(double coordinate, Wrap wrap) {
    const double reduced = wrap == Wrap::repeat ? coordinate - std::floor(coordinate)
                                                : std::clamp(coordinate, -1.0, 2.0);
    return std::isfinite(reduced) ? reduced : 0.0;
}

int wrapped(int index, int count, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp(index, 0, count - 1);
    if (index >= 0 && index < count) return index;
    if (wrap == Wrap::black) return -1;
    return index < 0 ? index + count : index - count;
}

Pair pair_at(double coordinate, int count, Wrap wrap) {
    const double place = in_range(coordinate, wrap) * count - 0.5;
    const double below = std::floor(place);
    const int first = static_cast<int>(below);
    return {wrapped(first, count, wrap), wrapped(first + 1, count, wrap),
            static_cast<float>(place - below)};
}

}  // namespace

Texels::Texels(std::shared_ptr<const Image> image, const TextureImage& how)
    : image_(std::move(image)),
      byte_values_(how.decode_srgb ? &decoded_byte_values() : &detail::byte_values),
      wrap_(how.wrap),
      scale_(how.scale) {}

Texels::Neighbours Texels::neighbours(const Vec2& st) const {
    const Pair s = pair_at(st.x, image_->width, wrap_), t = pair_at(st.y, image_->height, wrap_);
    Neighbours result{};
    std::size_t k = 0;
    for (const auto& [row, row_weight] :
         {std::pair(t.first, 1 - t.fraction), {t.second, t.fraction}}) {
        for (const auto& [column, weight] :
             {std::pair(s.first, 1 - s.fraction), {s.second, s.fraction}}) {
            if (row >= 0 && column >= 0) {
                const auto from_top = static_cast<std::size_t>(image_->height - 1 - row);
                result.texels[k] = from_top * image_->width + column;
                result.weights[k] = row_weight * weight;
            }
            ++k;
        }
    }
    return result;
}

template <class Value>
Value Texels::interpolated(const Vec2& st) const {
    const Neighbours near = neighbours(st);
    const auto stored = [&](auto value) {
        if constexpr (sizeof(value) == 1) {
            return (*byte_values_)[value];
        } else {
            return value;
        }
    };
    const auto texel = [&](const auto* p) {
        if constexpr (std::is_same_v<Value, float>) {
            return stored(p[0]);
        } else {
            return image_->channels < 3 ? Color(stored(p[0]))
                                        : Color(stored(p[0]), stored(p[1]), stored(p[2]));
        }
    };
    return std::visit(
        [&](const auto& values) {
            Value sum(0.0F);
            for (std::size_t k = 0; k < 4; ++k) {
                sum += texel(&values[near.texels[k] * image_->channels]) * near.weights[k];
            }
            return sum * scale_;
        },
        image_->pixels);
}

Color Texels::color(const Vec2& st) const {
    return interpolated<Color>(st);
}

float Texels::number(const Vec2& st) const {
    return interpolated<float>(st);
}

}  // namespace etalon
