#include "core/texture/texture_values.h"

#include <cmath>

#include "core/numerics/luminance.h"
#include "core/texture/mapping.h"
#include "core/texture/procedural.h"

namespace etalon {
namespace {

float value_of(const TextureValues& values, const NumberSlot& slot, const TexturePoint& point) {
    return values.number(slot, point);
}
Color value_of(const TextureValues& values, const ColorSlot& slot, const TexturePoint& point) {
    return values.color(slot, point);
}

float shown(const TextureImages& images, const ImageTexture<float>& texture, const Vec2& st) {
    return images.numbers[texture.image].number(st);
}
Color shown(const TextureImages& images, const ImageTexture<Color>& texture, const Vec2& st) {
    return images.colors[texture.image].color(st);
}

/// Returns the number of the check at a coordinate. Hits of a plane between two checks are on
/// either side of it, by rounding, and all are taken to be of the upper check.
double check_at(double x) {
    return std::floor(x + 0x1p-40 * (1 + std::abs(x)));
}

/// Returns whether checks whose numbers have this sum are of the first kind.
bool is_even(double sum) {
    return std::floor(sum / 2) == sum / 2;
}

/// Converts a colour to a value of a texture of type T.
template <class T>
T as(const Color& color) {
    if constexpr (std::is_same_v<T, float>) {
        return luminance(color);
    } else {
        return color;
    }
}

/// Evaluates one texture of type T at a point.
template <class T>
struct Evaluation {
    const TextureValues& values;
    const TextureImages& images;
    const TexturePoint& point;

    T of(const Slot<T>& slot) const { return value_of(values, slot, point); }

    T operator()(const ConstantTexture<T>& t) const { return t.value; }

    T operator()(const ScaleTexture<T>& t) const { return of(t.a) * of(t.b); }

    T operator()(const MixTexture<T>& t) const {
        const float amount = values.number(t.amount, point);
        return of(t.a) * (1 - amount) + of(t.b) * amount;
    }

    T operator()(const BilinearTexture<T>& t) const {
        const Imath::V2f st(texture_coordinates(t.mapping, point));
        return (t.v00 * (1 - st.y) + t.v01 * st.y) * (1 - st.x) +
               (t.v10 * (1 - st.y) + t.v11 * st.y) * st.x;
    }

    T operator()(const ImageTexture<T>& t) const {
        return shown(images, t, texture_coordinates(t.mapping, point));
    }

    T operator()(const Checkerboard2<T>& t) const {
        const Vec2 st = texture_coordinates(t.mapping, point);
        return of(is_even(check_at(st.x) + check_at(st.y)) ? t.even : t.odd);
    }

    T operator()(const Checkerboard3<T>& t) const {
        const Vec3 p = t.to_texture.point(point.position);
        return of(is_even(check_at(p.x) + check_at(p.y) + check_at(p.z)) ? t.even : t.odd);
    }

    T operator()(const DotsTexture<T>& t) const {
        return of(is_in_dot(texture_coordinates(t.mapping, point)) ? t.dot : t.ground);
    }

    T operator()(const FbmTexture& t) const { return T(procedural_value(t, point.position)); }
    T operator()(const WrinkledTexture& t) const { return T(procedural_value(t, point.position)); }
    T operator()(const WindyTexture& t) const { return T(procedural_value(t, point.position)); }
    T operator()(const MarbleTexture& t) const {
        return as<T>(procedural_value(t, point.position));
    }

    T operator()(const UvTexture& t) const {
        const Vec2 st = texture_coordinates(t.mapping, point);
        return as<T>({static_cast<float>(st.x - std::floor(st.x)),
                      static_cast<float>(st.y - std::floor(st.y)), 0});
    }
};

}  // namespace

TextureValues::TextureValues(const Textures& textures, std::vector<std::string>& problems)
    : textures_(textures),
      images_(read_texture_images(textures, problems)),
      steps_(etalon::difference_steps(textures, images_.numbers)) {}

float TextureValues::texture_number(std::uint32_t texture, const TexturePoint& point) const {
    return std::visit(Evaluation<float>{*this, images_, point}, textures_.numbers[texture]);
}

Color TextureValues::texture_color(std::uint32_t texture, const TexturePoint& point) const {
    return std::visit(Evaluation<Color>{*this, images_, point}, textures_.colors[texture]);
}

}  // namespace etalon
