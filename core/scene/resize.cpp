#include "core/scene/resize.h"

#include <algorithm>
#include <cstdint>

namespace etalon {
namespace {

Imath::Box2i resized(const Imath::Box2i& window, const Imath::V2i& from, const Imath::V2i& to) {
    Imath::Box2i result;
    for (int k = 0; k < 2; ++k) {
        const auto place = [&](int border) {
            const auto product = static_cast<std::int64_t>(border) * to[k];
            return static_cast<int>((product + from[k] - 1) / from[k]);
        };
        result.min[k] = std::min(place(window.min[k]), to[k] - 1);
        result.max[k] = std::max(place(window.max[k] + 1) - 1, result.min[k]);
    }
    return result;
}

}  // namespace

void resize(RenderSettings& settings, const Imath::V2i& size) {
    if (!settings.crop.isEmpty()) settings.crop = resized(settings.crop, settings.resolution, size);
    settings.resolution = size;
}

}  // namespace etalon
