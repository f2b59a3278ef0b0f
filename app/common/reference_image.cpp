#include "app/common/reference_image.h"

#include <fmt/format.h>

#include "core/image/io.h"

namespace etalon {
namespace {

Imath::V2i size_of(const Imath::Box2i& window) {
    return window.size() + Imath::V2i(1);
}

}  // namespace

Result<std::vector<Color>> read_reference(const std::string& path, const RenderSettings& settings) {
    const Imath::Box2i window = settings.window();
    Result<Image> file = read_image(path);
    if (!file) return {{}, file.error};
    Image& image = file.value;
    const Imath::V2i size(image.width, image.height), asked = size_of(window);
    const Imath::V2i& frame = settings.resolution;
    const bool elsewhere = size != frame && image.origin && *image.origin != window.min;
    if ((size != frame && size != asked) || elsewhere) {
        const std::string place =
            image.origin ? fmt::format(" at {},{}", image.origin->x, image.origin->y) : "";
        return {
            {},
            fmt::format("{}: {} x {} pixels{}; expected {} x {} at {},{}, or the frame of {} x {}",
                        path, size.x, size.y, place, asked.x, asked.y, window.min.x, window.min.y,
                        frame.x, frame.y)};
    }
    const bool as_displayed = settings.display_colors && settings.keep_display_values;
    std::vector<Color> pixels = as_displayed ? display_pixels(image) : linear_pixels(image);
    return {size == frame ? cut_out(pixels, size.x, window) : std::move(pixels), {}};
}

}  // namespace etalon
