#include "app/live/cost_map.h"

#include <algorithm>
#include <cmath>

#include "core/image/io.h"
#include "core/image/metrics/magma.h"
#include "core/numerics/pixel_window.h"

namespace etalon {
namespace {

/// Binary logarithm of the ratio of the highest cost to the lowest that is not black.
constexpr double range = 8;

Color color_of(double cost, double highest) {
    const std::array<std::uint8_t, 3> bytes =
        magma(cost > 0 ? 1 + std::log2(cost / highest) / range : 0);
    Color color;
    for (int k = 0; k < 3; ++k) color[k] = static_cast<float>(bytes[k]) / 255.0F;
    return color;
}

}  // namespace

std::string cost_map(const Imath::Box2i& window, const std::vector<double>& costs) {
    const double highest = *std::max_element(costs.begin(), costs.end());
    const Imath::V2i size = window_size(window);
    RenderedImage image{size.x, size.y, {Imath::V2i(0), size - Imath::V2i(1)}, {}, true, {}};
    image.pixels.reserve(costs.size());
    for (const double cost : costs) image.pixels.push_back(color_of(cost, highest));
    return encode_image("cost.png", image).value;
}

}  // namespace etalon
