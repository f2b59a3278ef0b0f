#include "app/common/reference_image.h"

#include <fmt/format.h>

#include "core/image/io.h"
#include "core/numerics/pixel_window.h"

namespace etalon {
namespace {

/// Returns whether an image begins at this place of its frame, as far as the file says.
bool is_at(const Image& image, const Imath::V2i& place) {
    const Imath::V2i first = image.frame ? image.frame->min : Imath::V2i(0);
    return !image.origin || *image.origin - first == place;
}

std::string extent_text(const Image& image) {
    std::string text = fmt::format("{} x {} pixels", image.width, image.height);
    if (image.origin) text += fmt::format(" at {},{}", image.origin->x, image.origin->y);
    if (!image.frame) return text;
    const Imath::V2i frame = window_size(*image.frame);
    return text + fmt::format(" of a frame of {} x {}", frame.x, frame.y);
}

}  // namespace

Result<std::vector<Color>> read_reference(const std::string& path, const RenderSettings& settings) {
    const Imath::Box2i window = settings.window();
    Result<Image> file = read_image(path);
    if (!file) return {{}, file.error};
    Image& image = file.value;
    const Imath::V2i size(image.width, image.height), asked = window_size(window);
    const Imath::V2i& frame = settings.resolution;
    const bool fits =
        (size == frame && is_at(image, {0, 0})) || (size == asked && is_at(image, window.min));
    const bool is_of_frame = !image.frame || window_size(*image.frame) == frame;
    if (!fits || !is_of_frame) {
        return {{},
                fmt::format("{}: {}; expected {} x {} at {},{}, or all, of a frame of {} x {}",
                            path, extent_text(image), asked.x, asked.y, window.min.x, window.min.y,
                            frame.x, frame.y)};
    }
    const bool as_displayed = settings.display_colors && settings.keep_display_values;
    std::vector<Color> pixels = as_displayed ? display_pixels(image) : linear_pixels(image);
    return {size == frame ? cut_out(pixels, size.x, window) : std::move(pixels), {}};
}

}  // namespace etalon
