#include "core/scene/camera.h"

namespace etalon {

ImageWindow centred_window(double half_side, double aspect) {
    const Vec2 half = half_side * (aspect > 1 ? Vec2(aspect, 1) : Vec2(1, 1 / aspect));
    return {-half.x, half.x, -half.y, half.y};
}

namespace {

/// Returns the centred window with the diagonal of another one and the shape of an image.
ImageWindow reshaped(const ImageWindow& window, const Imath::V2i& resolution) {
    const Vec2 size(resolution);
    const Vec2 half = size * (Vec2(window.width(), window.height()).length() / 2 / size.length());
    return {-half.x, half.x, -half.y, half.y};
}

}  // namespace

ImageWindow ProjectiveCamera::window(const Imath::V2i& resolution) const {
    if (fixed_window && lens) return reshaped(*fixed_window, resolution);
    if (fixed_window) return *fixed_window;
    return centred_window(half_side, static_cast<double>(resolution.x) / resolution.y);
}

}  // namespace etalon
